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

void append(std::vector<std::string>& words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
}

std::vector<std::string> common_flags() {
  return {"-std=c++20", "-I" MBCC_SOURCE_DIR "/runtime/include", "-I" MBCC_SOURCE_DIR "/tests"};
}

}  // namespace

bool has_rolled_loops(const std::string& header) {
  for (std::size_t at = 0; (at = header.find("for (std::size_t ", at)) != std::string::npos; ++at) {
    const std::size_t bound = header.find(" < ", at) + 3;
    if (header[bound] >= '0' && header[bound] <= '9') {
      return true;
    }
  }
  return false;
}

void EmittedModels::add(const std::string& name, const std::string& header) {
  names_.push_back(name);
  write_file(directory_ / (name + ".hpp"), header);
}

/// Writes a function per unit that serves its models, and a main program that calls all; returns the files.
std::vector<std::string> EmittedModels::write_units() {
  std::vector<std::string> files;
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
    files.push_back(directory_ / (serve + ".cpp"));
    write_file(files.back(), unit);
  }
  files.push_back(directory_ / "main.cpp");
  write_file(files.back(), "#include <fstream>\n" + declarations +
                               "int main(int, char** argv) {\n"
                               "  std::ifstream in(argv[1], std::ios::binary);\n"
                               "  std::ofstream out(argv[2], std::ios::binary);\n" +
                               calls + "  return in && out ? 0 : 1;\n}\n");
  return files;
}

Outcome EmittedModels::build(const std::vector<std::string>& flags) {
  std::vector<std::string> arguments = common_flags();
  append(arguments, flags);
  std::istringstream build_flags(MBCC_CXX_FLAGS);  // sanitizers, which the runtime was built with
  for (std::string flag; build_flags >> flag;) {
    arguments.push_back(flag);
  }
  append(arguments, write_units());
  append(arguments, {MBCC_RUNTIME_LIBRARY, "-o", (directory_ / "models").string()});
  return run_program(MBCC_CXX, arguments);
}

Outcome EmittedModels::check(const std::string& compiler, const std::vector<std::string>& flags) {
  std::vector<std::string> arguments = common_flags();
  append(arguments, flags);
  arguments.emplace_back("-fsyntax-only");
  append(arguments, write_units());
  return run_program(compiler, arguments);
}

std::vector<Answers> EmittedModels::ask(const std::vector<Question>& questions) const {
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
  std::vector<Answers> answers;
  for (const Question& question : questions) {
    Answers& of_model = answers.emplace_back();
    for (std::size_t i = 0; i < question.states.size(); ++i) {
      std::uint64_t size = 0;
      file.read(reinterpret_cast<char*>(&size), sizeof size);
      std::vector<double>& answer = of_model.emplace_back(size);
      file.read(reinterpret_cast<char*>(answer.data()), static_cast<std::streamsize>(size * sizeof(double)));
    }
  }
  return answers;
}

}  // namespace mbcc::test
