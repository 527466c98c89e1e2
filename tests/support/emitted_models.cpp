#include "emitted_models.hpp"

#include <cstdint>
#include <sstream>

namespace mbcc::test {

namespace {

/// Models per translation unit: enough to share the cost of the headers, few enough for the compiler's memory.
constexpr std::size_t models_per_unit = 25;

void put(std::ostream& out, const std::vector<double>& numbers) {
  out.write(reinterpret_cast<const char*>(numbers.data()),
            static_cast<std::streamsize>(numbers.size() * sizeof(double)));
}

}  // namespace

void EmittedModels::add(const std::string& name, const std::string& header) {
  names_.push_back(name);
  write_file(directory_ / (name + ".hpp"), header);
}

Outcome EmittedModels::build(const std::vector<std::string>& flags) {
  std::vector<std::string> arguments = {"-std=c++20", "-I" MBCC_SOURCE_DIR "/runtime/include",
                                        "-I" MBCC_SOURCE_DIR "/tests"};
  arguments.insert(arguments.end(), flags.begin(), flags.end());
  std::istringstream build_flags(MBCC_CXX_FLAGS);  // sanitizers, which the runtime was built with
  for (std::string flag; build_flags >> flag;) {
    arguments.push_back(flag);
  }
  std::string declarations, calls;
  for (std::size_t first = 0; first < names_.size(); first += models_per_unit) {
    const std::string serve = "serve_" + std::to_string(first);
    std::string unit, body;
    for (std::size_t i = first; i < std::min(first + models_per_unit, names_.size()); ++i) {
      unit += "#include \"" + names_[i] + ".hpp\"\n";
      body += "  mbcc::test::serve_states<" + names_[i] + "::Model>(in, out);\n";
    }
    const std::string signature = "void " + serve + "(std::istream& in, std::ostream& out)";
    unit += "#include \"support/serve_states.hpp\"\n" + signature + ";\n" + signature + " {\n" + body + "}\n";
    declarations += signature + ";\n";
    calls += "  " + serve + "(in, out);\n";
    write_file(directory_ / (serve + ".cpp"), unit);
    arguments.push_back(directory_ / (serve + ".cpp"));
  }
  write_file(directory_ / "main.cpp", "#include <fstream>\n" + declarations +
                                          "int main(int, char** argv) {\n"
                                          "  std::ifstream in(argv[1], std::ios::binary);\n"
                                          "  std::ofstream out(argv[2], std::ios::binary);\n" +
                                          calls + "  return in && out ? 0 : 1;\n}\n");
  for (const std::string& argument : {std::string(directory_ / "main.cpp"), std::string(MBCC_RUNTIME_LIBRARY),
                                      std::string("-o"), std::string(directory_ / "models")}) {
    arguments.push_back(argument);
  }
  return run_program(MBCC_CXX, arguments);
}

std::vector<Rates> EmittedModels::ask(const std::vector<Question>& questions) const {
  {
    std::ofstream file(directory_ / "questions", std::ios::binary);
    for (const Question& question : questions) {
      const std::uint64_t count = question.states.size();
      file.write(reinterpret_cast<const char*>(&count), sizeof count);
      for (std::size_t i = 0; i < count; ++i) {
        put(file, {question.times[i]});
        put(file, question.states[i]);
      }
    }
  }
  const Outcome outcome =
      run_program(directory_ / "models", {(directory_ / "questions").string(), (directory_ / "answers").string()});
  if (outcome.exit_code != 0) {
    throw std::runtime_error("the emitted models ended with " + std::to_string(outcome.exit_code));
  }
  std::ifstream file(directory_ / "answers", std::ios::binary);
  std::vector<Rates> answers;
  for (const Question& question : questions) {
    Rates& rates = answers.emplace_back();
    for (const std::vector<double>& state : question.states) {
      std::vector<double>& rate = rates.emplace_back(state.size());
      file.read(reinterpret_cast<char*>(rate.data()), static_cast<std::streamsize>(rate.size() * sizeof(double)));
    }
  }
  return answers;
}

}  // namespace mbcc::test
