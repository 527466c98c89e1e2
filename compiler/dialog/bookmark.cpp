#include "dialog/bookmark.hpp"

#include <nlohmann/json.hpp>

#include "dialog/item.hpp"

namespace mbcc::dialog {

// Found by the library through the namespace of their arguments.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Quantity, whole, components)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Particle, name, mass, position, velocity, force)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Draft, base, base_name, name, dimension, particle_count, equation_count, particles,
                                   equations, step, from, to)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Place, dialog, index, confirming)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Bookmark, draft, place, unfinished)

namespace {

constexpr const char* format = "mbcc dialog 1";

/// The file may have been edited: what the numbers in it promise must be there.
bool is_sound(const Bookmark& bookmark) {
  const Draft& draft = bookmark.draft;
  if (static_cast<std::size_t>(bookmark.place.dialog) >= dialog_table.size() ||
      particles(draft) > draft.particles.size() || equations(draft) > draft.equations.size()) {
    return false;
  }
  return bookmark.place.index < slots_of(bookmark.place.dialog, draft).size();
}

}  // namespace

std::string write_bookmark(const Bookmark& bookmark) {
  nlohmann::json json = bookmark;
  json["format"] = format;
  // Answers may hold bytes that are no UTF-8, which JSON cannot.
  return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::optional<Bookmark> read_bookmark(const std::string& text) {
  try {
    const nlohmann::json json = nlohmann::json::parse(text);
    const auto bookmark = json.get<Bookmark>();
    return json.at("format") == format && is_sound(bookmark) ? std::optional(bookmark) : std::nullopt;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

}  // namespace mbcc::dialog
