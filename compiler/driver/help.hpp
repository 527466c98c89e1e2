#pragma once
// `mbcc help TOPIC`. The manual page is made of the same texts.

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace mbcc {

/// A text of a title and an empty line; paragraphs that begin at the margin; and entries: an indented line with the
/// term, two blanks or more, and what is said of it, which may go on in lines that are indented to column 16 or beyond.
struct HelpTopic {
  std::string_view name;     ///< "" for the overview
  std::string_view heading;  ///< of its section in the manual page; none if empty
  std::string (*text)();
  bool is_example = false;  ///< shown as it stands, everywhere
};

std::span<const HelpTopic> help_topics();

/// The text on a topic, the overview for ""; nothing if there is no such topic.
std::optional<std::string> help_text(std::string_view topic);

/// "`language`, `functions`, ...".
std::string help_topic_names();

}  // namespace mbcc
