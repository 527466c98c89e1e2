// The command line of mbcc: docs/cli in `mbcc --help`.

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <string_view>

#include "driver/build.hpp"
#include "driver/commands.hpp"
#include "driver/exit_codes.hpp"
#include "driver/figures.hpp"
#include "driver/help.hpp"
#include "driver/model_input.hpp"
#include "model/methods.hpp"

namespace {

using namespace mbcc;

/// Commands of the contract that this version does not have yet: refused by name, never silently replaced.
constexpr std::array<std::string_view, 3> later_commands = {"equilibrium", "linearize", "sweep"};

void add_model_arguments(CLI::App& app, ModelArguments& arguments) {
  app.add_flag("--strict", arguments.strict, "hold forces and constraints to the paper's grammar");
  app.add_flag("--werror", arguments.werror, "warnings count as errors");
  app.add_option_function<std::string>(
         "--diagnostics", [&](const std::string& form) { arguments.json_diagnostics = form == "json"; },
         "form of the diagnostics on standard error")
      ->check(CLI::IsMember({"text", "json"}));
}

/// Parses with CLI11; the exit code if the program is to end here.
std::optional<int> parse(CLI::App& app, std::vector<std::string> arguments) {
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
  try {
    app.parse(arguments);
  } catch (const CLI::Success&) {
    fmt::print("{}", app.help());
    return exit_fine;
  } catch (const CLI::ParseError& error) {
    return refuse(fmt::format("{} (see `mbcc --help`)", error.what()));
  }
  return std::nullopt;
}

int compile_main(const std::vector<std::string>& words) {
  CLI::App app{"mbcc MODEL.mbd -o SIM.cpp: compile a model to a C++ program"};
  ModelArguments arguments;
  std::string output;
  std::string depfile;
  bool library = false;
  app.add_option("MODEL", arguments.model, "model file, - for standard input")->required();
  app.add_option("-o", output, "file to write, - for standard output");
  app.add_flag("--library", library, "emit the class alone: no main, no allocation, no streams");
  app.add_option("--method", arguments.method, "method of integration, instead of the model's own")
      ->check(CLI::IsMember(model::method_names()));
  app.add_option("--depfile", depfile, "also write the files that the output depends on, for make and ninja");
  add_model_arguments(app, arguments);
  if (const auto code = parse(app, words)) {
    return *code;
  }
  if (output.empty()) {
    return refuse("where should the program go: name a file with `-o`, `-o -` for standard output");
  }
  return compile_command(arguments, output, library, depfile);
}

/// The method among the flags of a simulation that needs a program of its own; empty for the others.
std::string recompiled_method(const std::vector<std::string>& flags) {
  constexpr std::string_view flag = "--method", with_value = "--method=";
  for (std::size_t i = 0; i < flags.size(); ++i) {
    const std::string method = flags[i].starts_with(with_value)           ? flags[i].substr(with_value.size())
                               : flags[i] == flag && i + 1 < flags.size() ? flags[i + 1]
                                                                          : "";
    if (model::needs_own_program(method)) {
      return method;
    }
  }
  return {};
}

/// What mbcc does not know is for the simulation.
int run_main(const std::vector<std::string>& words) {
  CLI::App app{"mbcc run MODEL.mbd [flags]: compile, build and run a model; flags are the simulation's"};
  ModelArguments arguments;
  std::string cxx_flags = default_cxx_flags;
  std::string plot;
  app.add_option("--cxxflags", cxx_flags, "flags for the C++ compiler")->capture_default_str();
  app.add_option("--plot", plot, "draw what the simulation records");
  app.set_help_flag();
  add_model_arguments(app, arguments);
  app.allow_extras();
  if (words.empty() || (words.front().size() > 1 && words.front().front() == '-')) {
    return refuse("`mbcc run` takes a model first: `mbcc run MODEL.mbd [flags]`");
  }
  arguments.model = words.front();
  if (const auto code = parse(app, {words.begin() + 1, words.end()})) {
    return *code;
  }
  const std::vector<std::string> flags = app.remaining();
  arguments.method = recompiled_method(flags);
  arguments.assembles = std::find(flags.begin(), flags.end(), "--assemble") != flags.end();
  return run_command(arguments, cxx_flags, flags, plot);
}

int plot_main(const std::vector<std::string>& words) {
  CLI::App app{"mbcc plot RESULT.csv ... -o FIGURE: draw recorded results, several over each other"};
  std::vector<std::string> results;
  std::string figure;
  app.add_option("RESULT", results, "files that `--csv` has recorded");
  app.add_option("-o", figure, "file to write: .svg, .png, .pdf, .gp for the script, or .html for a page");
  if (const auto code = parse(app, words)) {
    return *code;
  }
  if (results.empty() || figure.empty()) {
    return refuse("`mbcc plot` takes results and where to draw them: `mbcc plot RESULT.csv ... -o FIGURE`");
  }
  return draw_figure(results, subject_of_file(results.front()), figure);
}

int check_main(const std::vector<std::string>& words) {
  CLI::App app{"mbcc check MODEL.mbd: diagnostics, then the structure of the model"};
  ModelArguments arguments;
  app.add_option("MODEL", arguments.model, "model file, - for standard input")->required();
  add_model_arguments(app, arguments);
  const auto code = parse(app, words);
  return code ? *code : check_command(arguments);
}

int verify_main(const std::vector<std::string>& words) {
  CLI::App app{"mbcc verify MODEL.mbd SIM.cpp: is SIM.cpp what mbcc emits for the model?"};
  ModelArguments arguments;
  std::string emitted;
  app.add_option("MODEL", arguments.model, "model file")->required();
  app.add_option("SIM", emitted, "emitted file")->required();
  add_model_arguments(app, arguments);
  const auto code = parse(app, words);
  return code ? *code : verify_command(arguments, emitted);
}

int dump_main(const std::vector<std::string>& words) {
  CLI::App app{"mbcc dump MODEL.mbd --stage=STAGE: print one representation of the model"};
  ModelArguments arguments;
  std::string stage;
  bool partials = false;
  app.add_option("MODEL", arguments.model, "model file, - for standard input")->required();
  app.add_option("--stage", stage, "tokens, syntax, system, equations, derivatives or program")->required();
  app.add_flag("--partials", partials, "with derivatives: value, first and second partials of each constraint");
  add_model_arguments(app, arguments);
  const auto code = parse(app, words);
  return code ? *code : dump_command(arguments, stage, partials);
}

int dialog_main(const std::vector<std::string>& words) {
  CLI::App app{"mbcc dialog [MODEL.mbd]: ask for a model, question by question (mbcc help dialog)"};
  std::string model;
  std::string output;
  bool force = false;
  app.add_option("MODEL", model, "model file to start from");
  app.add_option("-o", output, "model file to write");
  app.add_flag("--force", force, "replace files without asking");
  if (const auto code = parse(app, words)) {
    return *code;
  }
  if (model == "-" || output == "-") {
    return refuse("a dialog reads answers and prints questions: name files for its models");
  }
  return dialog_command(model, output, force);
}

int help_main(const std::vector<std::string>& words) {
  const auto text = help_text(words.empty() ? "" : words.front());
  if (!text) {
    return refuse(fmt::format("there is no help on `{}`: topics are {}", words.front(), help_topic_names()));
  }
  fmt::print("{}", *text);
  return exit_fine;
}

struct Command {
  std::string_view name;
  int (*main)(const std::vector<std::string>& words);
};
constexpr std::array commands = {
    Command{"run", run_main},       Command{"plot", plot_main},   Command{"check", check_main},
    Command{"verify", verify_main}, Command{"dump", dump_main},   Command{"dialog", dialog_main},
    Command{"help", help_main},     Command{"--help", help_main}, Command{"-h", help_main}};

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.empty() && isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0) {
    return dialog_main(words);
  }
  if (words.empty()) {
    return refuse(
        "which model? `mbcc MODEL.mbd -o SIM.cpp` compiles one, `mbcc run MODEL.mbd` runs it; see `mbcc --help`");
  }
  if (words.front() == "--version") {
    fmt::print("mbcc {}\n", version);
    return exit_fine;
  }
  if (std::find(later_commands.begin(), later_commands.end(), words.front()) != later_commands.end()) {
    return refuse(fmt::format("`mbcc {}` is not available in this version of mbcc", words.front()));
  }
  for (const Command& command : commands) {
    if (words.front() == command.name) {
      return command.main({words.begin() + 1, words.end()});
    }
  }
  return compile_main(words);
}
