#include "driver/manual.hpp"

#include <fmt/format.h>

#include <vector>

#include "driver/help.hpp"
#include "emit/emit.hpp"

namespace mbcc {

namespace {

/// Text for troff: `code` in bold, nothing that it would take for its own.
std::string escaped(std::string_view text) {
  std::string result;
  bool is_code = false;
  for (const char c : text) {
    if (c == '`') {
      is_code = !is_code;
      result += is_code ? "\\fB" : "\\fR";
    } else if (c == '\\' || c == '-') {
      result += c == '\\' ? "\\e" : "\\-";
    } else {
      result += c;
    }
  }
  return result.starts_with('.') || result.starts_with('\'') ? "\\&" + result : result;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::size_t indentation(std::string_view line) { return std::min(line.find_first_not_of(' '), line.size()); }

/// The columns of an entry, as HelpTopic describes them: the term, and what is said of it.
std::vector<std::string_view> columns_of(std::string_view line) {
  std::vector<std::string_view> columns;
  while (!line.empty()) {
    line.remove_prefix(indentation(line));
    const std::size_t end = std::min(line.find("  "), line.size());
    columns.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
  return columns;
}

std::string entry(const std::vector<std::string_view>& columns) {
  std::string text = fmt::format(".TP\n\\fB{}\\fR\n", escaped(columns.front()));
  for (std::size_t i = 1; i < columns.size(); ++i) {
    text += escaped(columns[i]) + (i + 1 < columns.size() ? ":\n" : "\n");
  }
  return text;
}

std::string with_paragraphs_and_entries(const std::vector<std::string_view>& lines) {
  constexpr std::size_t continuation = 16;
  std::string page;
  bool in_paragraph = false;
  for (const std::string_view line : lines) {
    const std::size_t indent = indentation(line);
    const bool is_text = !line.empty() && indent == 0;
    if (is_text) {
      page += (in_paragraph ? "" : ".PP\n") + escaped(line) + "\n";
    } else if (indent >= continuation) {
      page += escaped(line.substr(indent)) + "\n";
    } else if (!line.empty()) {
      page += entry(columns_of(line));
    }
    in_paragraph = is_text;
  }
  return page;
}

std::string as_it_stands(const std::vector<std::string_view>& lines) {
  std::string page = ".PP\n.nf\n";
  for (const std::string_view line : lines) {
    page += escaped(line) + "\n";
  }
  return page + ".fi\n";
}

std::string section(const HelpTopic& topic) {
  const std::string text = topic.text();
  std::vector<std::string_view> lines = lines_of(text);
  if (topic.name.empty()) {
    lines.erase(lines.begin(), lines.begin() + 2);  // the title is that of the page
  }
  return fmt::format(".SH {}\n", topic.heading) +
         (topic.is_example ? as_it_stands(lines) : with_paragraphs_and_entries(lines));
}

/// The lines of the overview that call mbcc.
std::string synopsis() {
  const std::string overview = help_text("").value();
  std::string page;
  for (const std::string_view line : lines_of(overview)) {
    if (line.starts_with("  mbcc ")) {
      page += fmt::format("{}\\fB{}\\fR\n", page.empty() ? "" : ".br\n", escaped(columns_of(line).front()));
    }
  }
  return page;
}

}  // namespace

std::string manual_page() {
  std::string page = fmt::format(
      ".TH MBCC 1 \"\" \"mbcc {}\" \"User Commands\"\n"
      ".SH NAME\nmbcc \\- a compiler for mechanics\n"
      ".SH SYNOPSIS\n{}",
      version, synopsis());
  for (const HelpTopic& topic : help_topics()) {
    page += topic.heading.empty() ? "" : section(topic);
  }
  return page;
}

}  // namespace mbcc
