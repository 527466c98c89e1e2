#include "diagnostics/render.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace mbcc {
namespace {

/// The escape sequences that switch a terminal's colours, or nothing.
struct Palette {
  std::string_view bold, error, warning, note, caret, off;
};
constexpr Palette plain{"", "", "", "", "", ""};
constexpr Palette colourful{"\033[1m", "\033[1;31m", "\033[1;35m", "\033[1;36m", "\033[1;32m", "\033[0m"};

bool continues_a_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }
bool is_control(char byte) { return static_cast<unsigned char>(byte) < ' ' || byte == '\x7F'; }

/// A source line as it is shown, tabs as spaces and control characters blanked, and the column on the screen at
/// which each of its bytes (and its end) stands.
struct ShownLine {
  std::string text;
  std::vector<std::size_t> column;
};

/// Of a line too long to look at, the part around byte `first`, which becomes byte `first` of the result.
std::string clip(std::string_view line, std::size_t& first) {
  constexpr std::size_t longest = 300, before = 100, after = 150;
  constexpr std::string_view ellipsis = "...";
  if (line.size() <= longest) {
    return std::string(line);
  }
  std::size_t begin = first > before ? first - before : 0;
  std::size_t end = std::min(first + after, line.size());
  while (begin > 0 && continues_a_character(line[begin])) {
    --begin;
  }
  while (end < line.size() && continues_a_character(line[end])) {
    ++end;
  }
  const std::string_view head = begin > 0 ? ellipsis : "", tail = end < line.size() ? ellipsis : "";
  first += head.size() - begin;
  return fmt::format("{}{}{}", head, line.substr(begin, end - begin), tail);
}

ShownLine show(std::string_view line) {
  constexpr std::size_t tab_stop = 8;
  ShownLine shown;
  std::size_t column = 0;
  for (const char byte : line) {
    shown.column.push_back(continues_a_character(byte) && column > 0 ? column - 1 : column);
    if (byte == '\t') {
      const std::size_t width = tab_stop - column % tab_stop;
      shown.text.append(width, ' ');
      column += width;
    } else {
      shown.text += is_control(byte) ? ' ' : byte;
      column += continues_a_character(byte) ? 0U : 1U;
    }
  }
  shown.column.push_back(column);
  return shown;
}

std::string excerpt(Span span, const Sources& sources, const Palette& palette) {
  const Position start = sources.position(span);
  const std::string_view whole = sources[span.file].line(start.line);
  std::size_t first = std::min<std::size_t>(start.column - 1, whole.size());
  const std::string line = clip(whole, first);
  const ShownLine shown = show(line);
  const std::size_t last = std::min<std::size_t>(first + (span.end - span.begin), line.size());
  const std::size_t indent = shown.column[first];
  const std::size_t width = std::max<std::size_t>(shown.column[last], indent + 1) - indent;
  return fmt::format("{}\n{}{}^{}{}\n", shown.text, std::string(indent, ' '), palette.caret,
                     std::string(width - 1, '~'), palette.off);
}

std::string headline(Span span, const Sources& sources, const Palette& palette, std::string_view kind_colour,
                     std::string_view kind, std::string_view message) {
  const Position start = sources.position(span);
  return fmt::format("{}{}:{}:{}:{} {}{}:{} {}\n", palette.bold, sources[span.file].name(), start.line, start.column,
                     palette.off, kind_colour, kind, palette.off, message);
}

std::vector<const Diagnostic*> by_place(const Diagnostics& diagnostics) {
  std::vector<const Diagnostic*> ordered;
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    ordered.push_back(&diagnostic);
  }
  std::stable_sort(ordered.begin(), ordered.end(), [](const Diagnostic* a, const Diagnostic* b) {
    return a->span.file != b->span.file ? a->span.file < b->span.file : a->span.begin < b->span.begin;
  });
  return ordered;
}

nlohmann::ordered_json place(Span span, const Sources& sources) {
  const Position start = sources.position(span);
  const Position end = sources[span.file].position(span.end);
  return {{"file", sources[span.file].name()},
          {"line", start.line},
          {"column", start.column},
          {"end_line", end.line},
          {"end_column", end.column}};
}

}  // namespace

std::string render(const Diagnostic& diagnostic, const Sources& sources, Colours colours) {
  const Palette& palette = colours == Colours::On ? colourful : plain;
  const bool error = diagnostic.severity == Severity::Error;
  std::string text = headline(diagnostic.span, sources, palette, error ? palette.error : palette.warning,
                              error ? "error" : "warning", diagnostic.message);
  text += excerpt(diagnostic.span, sources, palette);
  for (const Note& note : diagnostic.notes) {
    text += headline(note.span, sources, palette, palette.note, "note", note.message);
    text += excerpt(note.span, sources, palette);
  }
  return text;
}

std::string render(const Diagnostics& diagnostics, const Sources& sources, Colours colours) {
  std::string text;
  for (const Diagnostic* diagnostic : by_place(diagnostics)) {
    text += render(*diagnostic, sources, colours);
  }
  return text;
}

std::string render_json(const Diagnostics& diagnostics, const Sources& sources) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const Diagnostic* diagnostic : by_place(diagnostics)) {
    nlohmann::ordered_json object = {{"severity", diagnostic->severity == Severity::Error ? "error" : "warning"},
                                     {"name", name_of(diagnostic->finding)}};
    object.update(place(diagnostic->span, sources));
    object["message"] = diagnostic->message;
    object["notes"] = nlohmann::ordered_json::array();
    for (const Note& note : diagnostic->notes) {
      nlohmann::ordered_json entry = place(note.span, sources);
      entry["message"] = note.message;
      object["notes"].push_back(entry);
    }
    all.push_back(object);
  }
  // A model may hold bytes that are no UTF-8, and a message may quote them; JSON cannot.
  return all.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace mbcc
