// `--strict`: what it looks at, and each of its messages whole.

#include <catch2/catch.hpp>
#include <set>

#include "syntax/front_end.hpp"

namespace mbcc {
namespace {

struct Case {
  Finding finding;
  std::string model;
  std::string message;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {Finding::StrictExpected, "constraint : x1'",
       R"(model.mbd:1:16: error: the paper's grammar expects an operator here, not `'`
constraint : x1'
               ^
)"},
      {Finding::StrictExpected, "constraint : (x1, y1)",
       R"(model.mbd:1:17: error: the paper's grammar expects an operator or `)` here, not `,`
constraint : (x1, y1)
                ^
)"},
      {Finding::StrictSign, "particle 1 { force = (0, -9.81*x1, 0) }",
       R"(model.mbd:1:26: error: the paper's grammar allows a sign only behind `(`: write `(-...)`
particle 1 { force = (0, -9.81*x1, 0) }
                         ^
)"},
      {Finding::StrictName, "force on 1 = (0, 2*bob.x, 0)",
       R"(model.mbd:1:20: error: `bob` is no variable of the paper's grammar: it knows `t` and numbered ones such as `x1` and `vz2`
force on 1 = (0, 2*bob.x, 0)
                   ^~~
)"},
      {Finding::StrictFunction, "constraint : x1 - sqrt(2)",
       R"(model.mbd:1:19: error: `sqrt` is not among the fifteen functions of the paper's grammar
constraint : x1 - sqrt(2)
                  ^~~~
)"},
      {Finding::StrictNumber, "constraint : x1 - 1E3",
       R"(model.mbd:1:19: error: the paper's grammar writes the exponent of `1E3` with a small `e`
constraint : x1 - 1E3
                  ^~~
)"},
      {Finding::StrictEquation, "constraint : x1^2 = 1",
       R"(model.mbd:1:19: error: the paper's grammar has no `=`: it writes a constraint as one expression that is zero
constraint : x1^2 = 1
                  ^
)"},
  };
  return all;
}

std::size_t errors(const std::string& model) { return StrictFrontEnd(model).diagnostics.errors(); }

}  // namespace

TEST_CASE("messages of --strict") {
  for (const Case& each : cases()) {
    INFO(each.model);
    CHECK(FrontEnd(each.model).accepted());
    const StrictFrontEnd front_end(each.model);
    CHECK(front_end.messages() == each.message);
    REQUIRE(front_end.diagnostics.all().size() == 1);
    CHECK(front_end.diagnostics.all().front().finding == each.finding);
  }
}

TEST_CASE("no message of --strict is left out") {
  std::set<Finding> tested;
  for (const Case& each : cases()) {
    tested.insert(each.finding);
  }
  const auto first = static_cast<int>(Finding::StrictExpected), last = static_cast<int>(Finding::StrictEquation);
  for (int finding = first; finding <= last; ++finding) {
    INFO(name_of(static_cast<Finding>(finding)));
    CHECK(tested.count(static_cast<Finding>(finding)) == 1);
  }
}

TEST_CASE("the flag --strict holds forces and constraints to the paper's grammar and nothing else") {
  CHECK(errors("particle 1 { mass = -1; position = (-1, sqrt(2), 0); velocity = -v }") == 0);
  CHECK(errors("let a = -sqrt(2); output b = -x1'; gravity -9.81; parameter c = -1E3") == 0);
  CHECK(errors("integrate { from = -1 }") == 0);
  CHECK(errors("for i in 1..2 { for j in 1..2 { constraint : -x1; force on 1 = (-1, -2, -3) } }") == 4);
}

TEST_CASE("every component and every side is held to it") {
  CHECK(errors("particle 1 { force = (-1, sqrt(2), (-3)) }") == 2);
  CHECK(errors("constraint : -x1 = sqrt(2)") == 3);
  CHECK(errors("particle 1 { force = -x1 }") == 1);
  CHECK(errors("particle 1 { force = (-x1) }") == 0);
}

}  // namespace mbcc
