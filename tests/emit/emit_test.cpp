// Emitted text as a whole: one model reviewed line by line, and what texts of other scenes must not contain.
// After a wanted change, MBCC_ACCEPT=1 in the environment writes the reviewed text anew.

#include "emit/emit.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>

#include "support/compiled.hpp"
#include "support/run_program.hpp"
#include "support/scenes.hpp"

namespace mbcc::test {
namespace {

std::string emitted(const std::string& text, const EmitOptions& options = {}, const std::string& file = "model.mbd") {
  const Compilation c = compile(file, text, {});
  INFO(messages_of(c));
  REQUIRE(c.program);
  return emit(*c.program, *c.system, c.sources, options);
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const std::filesystem::path source = MBCC_SOURCE_DIR;

}  // namespace

TEST_CASE("the planar pendulum is emitted as reviewed") {
  const std::string model = read_file(source / "examples/planar_pendulum/planar_pendulum.mbd");
  const std::string text = emitted(model, {}, "planar_pendulum.mbd");
  const std::filesystem::path golden = source / "tests/emit/golden/planar_pendulum.txt";
  if (std::getenv("MBCC_ACCEPT") != nullptr) {
    write_file(golden, text);
  }
  CHECK(text == read_file(golden));
}

TEST_CASE("emitted text depends on the model and the options alone") {
  for (const std::string& model : {chain(40), wheel(20), cluster(5)}) {
    CHECK(emitted(model) == emitted(model));
    CHECK(emitted(model, {}, "/some/where/model.mbd") == emitted(model, {}, "model.mbd"));
  }
}

TEST_CASE("the header names the options") {
  for (const bool library : {false, true}) {
    for (const bool strict : {false, true}) {
      for (const std::string method : {"", "taylor"}) {
        const auto options = options_of(emitted(springs(1), {library, strict, method}));
        REQUIRE(options);
        CHECK(options->library == library);
        CHECK(options->strict == strict);
        CHECK(options->method == method);
      }
    }
  }
  CHECK_FALSE(options_of("int main() {}\n"));
}

TEST_CASE("a program has Taylor series where its model names a method that takes them, and nothing of them elsewhere") {
  const auto with_method = [](const std::string& method) {
    return springs(3) + "integrate { from = 0; to = 1; step = 0.1; method = " + method + " }\n";
  };
  for (const bool library : {false, true}) {
    for (const std::string method : {"taylor", "auto"}) {
      const std::string text = emitted(with_method(method), {library, false});
      CHECK(contains(text, "using Series = mbrt::Series<"));
      CHECK(contains(text, "bool expand(const State& y, std::size_t order, Series& s)"));
    }
    for (const std::string method : {"rk4", "dop853"}) {
      const std::string text = emitted(with_method(method), {library, false});
      CHECK_FALSE(contains(text, "eries"));
      CHECK_FALSE(contains(text, "expand"));
    }
  }
  CHECK(contains(emitted(with_method("taylor")), "mbrt::simulate<mbrt::Taylor>(model, argc, argv)"));
}

TEST_CASE("a program has derivatives of its rates where its model names a method that takes them, and only there") {
  for (const std::string& model : {chain(2), springs(3)}) {
    const auto with_method = [&](const std::string& method) {
      return model + "integrate { from = 0; to = 1; step = 0.1; method = " + method + " }\n";
    };
    for (const std::string method : {"radau", "auto"}) {
      CHECK(contains(emitted(with_method(method)), "bool tangent(const State& "));
    }
    for (const std::string method : {"rk4", "dop853", "taylor"}) {
      CHECK_FALSE(contains(emitted(with_method(method)), "tangent"));
      CHECK_FALSE(contains(emitted(with_method(method)), "direction"));
    }
    CHECK(contains(emitted(with_method("radau")), "mbrt::simulate<mbrt::Radau>(model, argc, argv)"));
    CHECK(contains(emitted(with_method("auto")),
                   "mbrt::simulate<mbrt::Dop853, mbrt::Taylor, mbrt::Radau>(model, argc, argv)"));
  }
}

TEST_CASE("a scene without constraints has no solver in its text") {
  for (const std::string& model : {cluster(4), springs(3)}) {
    const std::string text = emitted(model);
    for (const char* absent :
         {"climb", "Island ", "IslandStorage", "constraint_errors", "island_rows", "outputs(", "safe"}) {
      INFO(absent);
      CHECK_FALSE(contains(text, absent));
    }
  }
}

TEST_CASE("what a scene does not have is not in its text") {
  CHECK_FALSE(contains(emitted("dimension 2\nparticle 1 { mass = 1; position = (0, 1) }\n"), "applied_forces"));
  CHECK_FALSE(contains(emitted(springs(2)), "energy("));
  CHECK(contains(emitted(chain(2)), "energy("));
  const std::string plane = emitted("dimension 2\nparticle bob { mass = 1; position = (0, 1) }\n");
  CHECK_FALSE(contains(plane, "bob_z"));
  CHECK_FALSE(contains(plane, "\"bob.z\""));
  for (const std::string& model : {chain(3), cluster(3), wheel(2)}) {
    CHECK_FALSE(contains(emitted(model), "Eigen"));
    CHECK_FALSE(contains(emitted(model), "std::vector"));
  }
}

TEST_CASE("constant rows leave no pivot and no ladder in the text of the rates") {
  const std::string text = emitted(R"(dimension 1
particle 1 { mass = 2; position = 0; force = -x1 }
particle 2 { mass = 3; position = 0 }
constraint : 2*x1 + x2 = 0
)");
  const std::size_t begin = text.find("void rates("), end = text.find("mbrt::Island island(");
  REQUIRE(begin < end);
  const std::string rates = text.substr(begin, end - begin);
  CHECK_FALSE(contains(rates, "S_constraint_1"));
  CHECK_FALSE(contains(rates, "floor"));
  CHECK_FALSE(contains(rates, "climb"));
  CHECK_FALSE(contains(rates, " / "));
}

TEST_CASE("the constraint's text and line stand above its solve, on one line") {
  const std::string text = emitted(
      "dimension 2\nparticle 1 { mass = 1; position = (0, 1) }\nconstraint rod : x1^2 +   # a comment\n  y1^2 = 1\n");
  CHECK(contains(text, "    //   rod (model.mbd:3): x1^2 + y1^2 = 1\n"));
}

TEST_CASE("sine and cosine of one angle are computed together") {
  const std::string text = emitted("dimension 1\nparticle 1 { mass = 1; position = 0; force = sin(x1)*cos(x1) }\n");
  CHECK(contains(text, "] = mbrt::sincos(x1);"));
  CHECK_FALSE(contains(text, "std::sin"));
}

TEST_CASE("names that C++ or the text itself uses are mangled, and kept in the tables") {
  const std::string text = emitted(R"(dimension 1
parameter class = 2
particle y { mass = class; position = 0; force = -rate*y.x }
parameter rate = 1
)");
  CHECK(contains(text, "{\"class\", 2.0}, {\"rate\", 1.0}"));
  CHECK(contains(text, "const double rate_v = parameters_[1];"));
  CHECK(contains(text, "\"y.x\""));
}

TEST_CASE("models of runs that project, and no others, have code for it") {
  const std::string adaptive = emitted(chain(3));
  CHECK(contains(adaptive, "void project(State& y) {"));
  CHECK(contains(adaptive, "return mbrt::simulate<mbrt::Dop853>(model, argc, argv);"));
  const std::string constant = emitted(std::string(chain(3)) + "integrate { to = 1; step = 0.1 }\n");
  CHECK_FALSE(contains(constant, "shift"));
  CHECK(contains(constant, "return mbrt::simulate<mbrt::Rk4>(model, argc, argv);"));
  CHECK_FALSE(contains(emitted(springs(3)), "shift"));
}

TEST_CASE("a file's name becomes a namespace, whatever it is") {
  CHECK(contains(emitted(springs(1), {}, "class.mbd"), "namespace class_v {"));
  CHECK(contains(emitted(springs(1), {}, "my-model 2.mbd"), "namespace my_model_2 {"));
  CHECK(contains(emitted(springs(1), {}, "3.mbd"), "namespace n3 {"));
  CHECK(contains(emitted(springs(1), {}, "std.mbd"), "namespace std_v {"));
}

}  // namespace mbcc::test
