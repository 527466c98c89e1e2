#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "rules.hpp"

using mbcc::layers::broken_rules;

namespace {

std::string read(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

bool is_code(const std::filesystem::path& path) {
  return path.extension() == ".cpp" || path.extension() == ".hpp" || path.extension() == ".def";
}

}  // namespace

TEST_CASE("the compiler keeps its rules") {
  const std::filesystem::path compiler = std::filesystem::path(MBCC_SOURCE_DIR) / "compiler";
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(compiler)) {
    if (is_code(entry.path())) {
      const std::string path = entry.path().lexically_relative(compiler).generic_string();
      INFO("compiler/" << path);
      CHECK(broken_rules(path, read(entry.path())) == std::vector<std::string>{});
      ++files;
    }
  }
  CHECK(files > 9);  // more than one per layer: the folder was found
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
  SECTION("third parties") {
    CHECK(includes("syntax/parser.cpp", "<boost/spirit/home/x3.hpp>"));
    CHECK_FALSE(includes("syntax/parser.hpp", "<boost/spirit/home/x3.hpp>"));
    CHECK_FALSE(includes("model/resolve.cpp", "<boost/spirit/home/x3.hpp>"));
    CHECK(includes("mechanics/examine.cpp", "<Eigen/SVD>"));
    CHECK_FALSE(includes("mechanics/examine.hpp", "<Eigen/SVD>"));
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
