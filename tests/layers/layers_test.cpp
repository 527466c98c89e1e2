#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "rules.hpp"

using mbcc::layers::broken_rules;
using mbcc::layers::Files;
using mbcc::layers::sources_that_reach;
using Paths = std::vector<std::string>;

namespace {

std::string read(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

Files compiler_files() {
  const std::filesystem::path compiler = std::filesystem::path(MBCC_SOURCE_DIR) / "compiler";
  Files files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(compiler)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".cpp" || extension == ".hpp" || extension == ".def") {
      files.emplace(entry.path().lexically_relative(compiler).generic_string(), read(entry.path()));
    }
  }
  return files;
}

}  // namespace

TEST_CASE("the compiler keeps its rules") {
  for (const auto& [path, text] : compiler_files()) {
    INFO("compiler/" << path);
    CHECK(broken_rules(path, text) == Paths{});
  }
}

TEST_CASE("heavy third parties stay in few source files") {
  const Files files = compiler_files();
  CHECK(sources_that_reach("boost/", files) == Paths{"syntax/parser.cpp"});
  for (const std::string& path : sources_that_reach("Eigen/", files)) {
    CHECK(path.rfind("mechanics/", 0) == 0);
  }
}

TEST_CASE("a header is reached through others") {
  const Files files = {{"a.cpp", "#include \"b.hpp\"\n"},
                       {"b.hpp", "#pragma once\n#include \"c.hpp\"\n#include \"b.hpp\"\n"},
                       {"c.hpp", "#include <boost/x.hpp>\n"},
                       {"d.cpp", "#include <vector>\n#include \"e.hpp\"\n"}};
  CHECK(sources_that_reach("boost/", files) == Paths{"a.cpp"});
  CHECK(sources_that_reach("Eigen/", files) == Paths{});
}

TEST_CASE("an include that breaks the order of the house is seen") {
  const auto includes = [](const char* path, const char* header) {
    return broken_rules(path, std::string("#include ") + header + "\n").empty();
  };
  SECTION("to the left, not to the right") {
    CHECK(includes("graph/graph.cpp", "\"graph/graph.hpp\""));
    CHECK(includes("driver/compile.cpp", "\"emit/emit.hpp\""));
    CHECK(includes("model/system.hpp", "\"graph/operators.hpp\""));
    CHECK_FALSE(includes("graph/graph.cpp", "\"syntax/ast.hpp\""));
    CHECK_FALSE(includes("source/source.hpp", "\"diagnostics/assert.hpp\""));
    CHECK_FALSE(includes("emit/emit.cpp", "\"driver/compile.hpp\""));
  }
  SECTION("the runtime") {
    CHECK(includes("driver/interpreter.cpp", "\"mbrt/model.hpp\""));
    CHECK_FALSE(includes("emit/emit.cpp", "\"mbrt/model.hpp\""));
  }
  CHECK_FALSE(broken_rules("utilities/strings.hpp", "").empty());
}

TEST_CASE("C++ text in strings is the emitter's") {
  const auto accepts = [](const char* path, const char* line) { return broken_rules(path, line).empty(); };
  CHECK(accepts("emit/writer.cpp", R"(out += "const double x = 1;\n";)"));
  CHECK(accepts("model/print.cpp", R"(out += "constraint {} : {}\n";)"));
  CHECK_FALSE(accepts("program/print.cpp", R"(out += "const double x = 1;\n";)"));
  CHECK_FALSE(accepts("driver/main.cpp", R"(out += "};\n";)"));
  CHECK_FALSE(accepts("program/print.cpp", R"(out += "std::sin(";)"));
  CHECK_FALSE(accepts("driver/main.cpp", R"(out += "#include <cmath>";)"));
}
