#include "driver/gnuplot.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "driver/files.hpp"
#include "driver/process.hpp"

namespace mbcc {

std::string obstacle_to_gnuplot() {
  return is_on_path("gnuplot") ? ""
                               : "figures are drawn by gnuplot, which is not installed (in Debian it is the package "
                                 "gnuplot-nox); a name that ends in `.gp` gets its script";
}

std::string draw_with_gnuplot(const std::function<std::string(const std::string& output)>& script_for,
                              const std::string& path) {
  const TemporaryFile picture(path, "tmp"), script(path, "gp"), log(path, "log");
  if (!write_file(script.path(), script_for(picture.path()))) {
    return fmt::format("cannot write `{}`", path);
  }
  const ProcessEnd end = run_process({"gnuplot", script.path()}, log.path());
  std::error_code failure;
  if (end.exit_code != 0 || !std::filesystem::exists(picture.path(), failure)) {
    std::string reason = read_file(log.path()).value_or("");
    reason.resize(reason.find_last_not_of('\n') + 1);
    return fmt::format("gnuplot could not draw `{}`: {}", path, reason);
  }
  std::filesystem::rename(picture.path(), path, failure);
  return failure ? fmt::format("cannot write `{}`", path) : "";
}

}  // namespace mbcc
