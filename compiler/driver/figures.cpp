#include "driver/figures.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string_view>

#include "diagnostics/render.hpp"
#include "driver/exit_codes.hpp"
#include "driver/files.hpp"
#include "driver/gnuplot.hpp"
#include "driver/model_input.hpp"
#include "figure/script.hpp"
#include "page/page.hpp"

namespace mbcc {

namespace {

using figure::Format;
using figure::Table;
using Tables = std::vector<Table>;

std::string nothing_in_the_way() { return {}; }

std::string write_text(const std::string& path, const std::string& text) {
  return write_file(path, text) ? "" : fmt::format("cannot write `{}`", path);
}

template <Format format>
std::string draw(const Tables& results, const Subject&, const std::string& path) {
  return draw_with_gnuplot([&](const std::string& output) { return gnuplot_script(results, format, output); }, path);
}

/// The script itself, which draws a picture of its own name.
std::string write_script(const Tables& results, const Subject&, const std::string& path) {
  const std::string picture = path.substr(0, path.rfind('.')) + ".svg";
  return write_text(path, gnuplot_script(results, Format::Svg, picture));
}

std::string obstacle_to_pages() {
  return page::available() ? ""
                           : "this mbcc was built without HTML pages: their libraries come by npm (in Debian the "
                             "packages nodejs and npm), which was not there";
}

std::string write_page(const Tables& results, const Subject& subject, const std::string& path) {
  if (results.size() > 1) {
    return fmt::format("a page shows one result, and these are {}", results.size());
  }
  return write_text(path, page::write_page(results.front(), subject.skeleton, subject.title, subject.source));
}

/// A form of figures. Both functions return what is wrong, or nothing.
struct Form {
  std::string_view ending;
  std::string (*obstacle)();
  std::string (*write)(const Tables& results, const Subject& subject, const std::string& path);
};
constexpr std::array forms = {
    Form{".svg", obstacle_to_gnuplot, draw<Format::Svg>}, Form{".png", obstacle_to_gnuplot, draw<Format::Png>},
    Form{".pdf", obstacle_to_gnuplot, draw<Format::Pdf>}, Form{".gp", nothing_in_the_way, write_script},
    Form{".html", obstacle_to_pages, write_page}};

const Form* form_of(const std::string& path) {
  const auto found =
      std::find_if(forms.begin(), forms.end(), [&](const Form& form) { return path.ends_with(form.ending); });
  return found == forms.end() ? nullptr : &*found;
}

/// Places in a text are counted in 32 bits.
bool is_too_large(const std::string& path) {
  std::error_code failure;
  const std::uintmax_t size = std::filesystem::file_size(path, failure);
  return !failure && size > std::numeric_limits<std::uint32_t>::max();
}

/// Nothing, with a message, if one of them is no result.
std::optional<Tables> read_results(const std::vector<std::string>& paths) {
  Sources sources;
  Diagnostics diagnostics;
  Tables results;
  for (const std::string& path : paths) {
    if (is_too_large(path)) {
      refuse(fmt::format("`{}` is larger than four gigabytes: `--every` records fewer rows", path));
      return std::nullopt;
    }
    std::optional<std::string> text = read_file(path);
    if (!text) {
      refuse(fmt::format("cannot read `{}`", path));
      return std::nullopt;
    }
    if (auto result = figure::read_table(sources, sources.add(path, std::move(*text)), diagnostics)) {
      results.push_back(std::move(*result));
    }
  }
  fmt::print(stderr, "{}", render(diagnostics, sources, isatty(STDERR_FILENO) != 0 ? Colours::On : Colours::Off));
  return diagnostics.has_errors() ? std::nullopt : std::optional(std::move(results));
}

bool holds_time_alone(const Table& result) { return result.names.size() == 1; }

}  // namespace

std::string obstacle_to_figure(const std::string& path) {
  const Form* const form = form_of(path);
  if (form != nullptr) {
    return form->obstacle();
  }
  std::string endings;
  for (const Form& other : forms) {
    const bool first = &other == &forms.front();
    const bool last = &other == &forms.back();
    endings += fmt::format("{}`{}`", first ? "" : last ? " or " : ", ", other.ending);
  }
  return fmt::format("which form of figure is `{}`: its name must end in {}", path, endings);
}

int draw_figure(const std::vector<std::string>& results, const Subject& subject, const std::string& path) {
  if (const std::string obstacle = obstacle_to_figure(path); !obstacle.empty()) {
    return refuse(obstacle);
  }
  if (results.size() > figure::most_results) {
    return refuse(
        fmt::format("one figure shows at most {} results, and these are {}", figure::most_results, results.size()));
  }
  const std::optional<Tables> tables = read_results(results);
  if (!tables) {
    return exit_wrong_usage;
  }
  if (std::all_of(tables->begin(), tables->end(), holds_time_alone)) {
    return refuse(fmt::format("there is nothing to draw: `{}` holds the time alone", tables->front().name));
  }
  const std::string failure = form_of(path)->write(*tables, subject, path);
  return failure.empty() ? static_cast<int>(exit_fine) : refuse(failure);
}

}  // namespace mbcc
