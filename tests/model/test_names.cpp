#include <catch2/catch.hpp>

#include "model/names.hpp"
#include "resolved.hpp"

namespace mbcc {
namespace {

using test::printed;
using test::resolve_files;
using test::resolve_text;
using test::shown;
using test::system_of;

TEST_CASE("statements may stand in any order") {
  const std::string model =
      "dimension n\n"
      "constant n = two\n"
      "constant two = 2\n"
      "for i in 1..n { particle p[i] { mass = m; position = d[i] } }\n"
      "for i in 1..n { let d[i] = (i, far) }\n"
      "parameter m = 3\n"
      "let far = 7*m\n";
  const std::string reversed =
      "let far = 7*m\n"
      "parameter m = 3\n"
      "for i in 1..n { let d[i] = (i, far) }\n"
      "for i in 1..n { particle p[i] { mass = m; position = d[i] } }\n"
      "constant two = 2\n"
      "constant n = two\n"
      "dimension n\n";
  CHECK(printed(model) == printed(reversed));
  CHECK(printed(model).find("p[2].y: starts at 7*m") != std::string::npos);
}

TEST_CASE("names in loops are seen everywhere if indexed, and in their pass only if not") {
  CHECK(shown("r[1] + r[2]", "for i in 1..2 { let half = i/2; let r[i] = half*x1 }") == "0.5*x1 + 1*x1");
  CHECK(shown("k",
              "for i in 1..2 { let same = i; output o[i] = same*x1 }\n"
              "for i in 3..3 { let same = i; output o[i] = same*x1 }") == "1*x1, 2*x1, 3*x1, k");
  const std::string outside = "for i in 1..2 { let half = i; output o[i] = half }\noutput p = half\n";
  CHECK(resolve_text(outside).messages().find("unknown name `half`") != std::string::npos);
  const std::string inner =
      "for i in 1..1 { for j in 1..1 { let a = j; output o[i] = a }; let a = i; output q[i] = a }";
  CHECK(resolve_text(inner).messages().find("`a` would hide") != std::string::npos);
}

TEST_CASE("constants, parameters and particles may be indexed, in and outside of loops") {
  CHECK(shown("c[1]*x1 + c[2]*y1", "constant c[1] = 5\nconstant c[n] = 6\nconstant n = 2") == "5*x1 + 6*y1");
  const model::System system = system_of(
      "dimension 1\nparticle p[0] { mass = w[1]; position = 0 }\n"
      "for i in 1..2 { parameter w[i] = i\nparticle p[i] { mass = w[i]; position = p0*i } }\nlet p0 = 1\n");
  REQUIRE(system.parameters.size() == 2);
  CHECK(system.parameters[1].name == "w[2]");
  CHECK(system.parameters[1].value == 2);
  CHECK(system.coordinates[2].name == "p[2].x");
}

TEST_CASE("elements may have several indices") {
  const model::System system = system_of(
      "dimension 1\nfor i in 1..2 { for j in 1..2 { particle q[i, j] { mass = 1; position = 10*i + j } } }\n"
      "constraint : q[1, 2].x = q[2, 1].x\n");
  CHECK(system.coordinates[1].name == "q[1,2].x");
  CHECK(system.speeds[2].acceleration == "q[2,1].ax");
  CHECK(printed("dimension 1\nparticle q[1, 2] { mass = 1; position = 3 }").find("q[1,2].x: starts at 3") !=
        std::string::npos);
}

TEST_CASE("names that only look like the language's own are free") {
  CHECK(shown("x0 + y + vz + t12 + int + x01",
              "let x0 = x1\nlet y = 1\nlet vz = 2\nlet t12 = 3\nlet int = 4\nlet x01 = 5") == "x1 + 1 + 2 + 3 + 4 + 5");
  CHECK(model::reserved_as("vz3") == "a variable of a numbered particle");
  CHECK(model::reserved_as("vz0").empty());
  CHECK(model::reserved_as("x").empty());
  CHECK(model::reserved_as("cross") == "a function");
}

TEST_CASE("an output may be called like anything but a column") {
  CHECK(resolve_text("particle bob { mass = 1; position = (0, 0, 0) }\nlet r = bob.x\noutput r = r\noutput bob = r")
            .system);
  const auto taken = resolve_text("particle bob { mass = 1; position = (0, 0, 0) }\noutput bob = (1, 2)");
  CHECK(taken.messages().find("`bob.x` cannot be declared: it is a column of every result") != std::string::npos);
}

TEST_CASE("imported files count once, wherever they are imported") {
  const test::Files files = {{"main.mbd",
                              "import \"a/left.mbd\"\nimport \"a/right.mbd\"\nlet all = left + right\n"
                              "particle 1 { mass = base; position = (all, 0, 0) }\n"},
                             {"a/left.mbd", "system left\nimport \"../base.mbd\"\nlet left = base"},
                             {"a/right.mbd", "system right\nimport \"../a/../base.mbd\"\nlet right = 2*base"},
                             {"base.mbd", "constant base = 5"}};
  const auto resolved = resolve_files(files, "main.mbd");
  CHECK(resolved.messages().empty());
  REQUIRE(resolved.system);
  CHECK(resolved.sources.size() == 4);
  CHECK(resolved.system->name == "main");
  CHECK((*resolved.system)[resolved.system->coordinates[0].initial].number == 15);
}

TEST_CASE("the system's name is that of its statement, or of the file") {
  CHECK(system_of("particle 1 { mass = 1; position = (0, 0, 0) }").name == "model");
  CHECK(system_of("system arm\nparticle 1 { mass = 1; position = (0, 0, 0) }").name == "arm");
  CHECK(resolve_files({{"a.b/two.parts.mbd", "dimension 2"}}, "a.b/two.parts.mbd").system->name == "two.parts");
}

}  // namespace
}  // namespace mbcc
