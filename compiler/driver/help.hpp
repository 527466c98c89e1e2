#pragma once
// `mbcc help TOPIC`.

#include <optional>
#include <string>
#include <string_view>

namespace mbcc {

/// The text on a topic, the overview for ""; nothing if there is no such topic.
std::optional<std::string> help_text(std::string_view topic);

std::string help_topics();

}  // namespace mbcc
