// Programs of random and of repetitive scenes: every operand is there before it is used, nothing is computed in vain,
// and everything at its own level.

#include <catch2/catch.hpp>
#include <set>

#include "program/lower.hpp"
#include "program/schedule.hpp"
#include "support/compiled.hpp"
#include "support/random_expression.hpp"
#include "support/random_scene.hpp"
#include "support/scenes.hpp"
#include "support/tracked.hpp"

namespace mbcc::program {
namespace {

using graph::Expr;
using graph::Graph;
using graph::Kind;
using graph::Node;
using test::Random;
using test::Tracked;

std::vector<const Section*> sections_of(const Kernel& kernel) {
  std::vector<const Section*> sections;
  for (const Section& section : kernel.sections) {
    sections.push_back(&section);
  }
  for (const IslandSolve& island : kernel.islands) {
    sections.push_back(&island.solve);
  }
  return sections;
}

std::vector<NodeId> order_of(const Kernel& kernel) {
  std::vector<NodeId> order;
  for (const Section* section : sections_of(kernel)) {
    for (const Unit& unit : section->units) {
      order.insert(order.end(), unit.order.begin(), unit.order.end());
    }
  }
  return order;
}

/// What a kernel is for: values that it stores, judges or provides.
std::set<NodeId> purposes_of(const Kernel& kernel) {
  std::set<NodeId> purposes(kernel.provides.begin(), kernel.provides.end());
  for (const Section* section : sections_of(kernel)) {
    for (const Unit& unit : section->units) {
      for (const Store& store : unit.stores) {
        purposes.insert(store.value);
      }
      for (const Guard& guard : unit.guards) {
        purposes.insert({guard.diagonal, guard.pivot, guard.scale});
      }
    }
  }
  return purposes;
}

void check_kernel(const Kernel& kernel, const Graph& graph, const std::set<NodeId>& provided) {
  const std::vector<NodeId> order = order_of(kernel);
  const std::set<NodeId> purposes = purposes_of(kernel);
  std::set<NodeId> known, used = purposes;
  for (const NodeId id : order) {
    const Node& node = graph[id];
    REQUIRE(node.kind == Kind::Apply);
    REQUIRE(known.insert(id).second);  // once
    // Constant operations that have no finite value stay; they are computed where they are used.
    REQUIRE((node.level == kernel.level || (node.level == Level::Constant && kernel.level == Level::Parameter)));
    for (const NodeId operand : node.used_operands()) {
      REQUIRE((graph[operand].kind != Kind::Apply || known.contains(operand) || provided.contains(operand)));
      used.insert(operand);
    }
  }
  for (const NodeId id : order) {
    REQUIRE(used.contains(id));
  }
  for (const NodeId id : purposes) {
    REQUIRE((graph[id].kind != Kind::Apply || known.contains(id) || provided.contains(id)));
  }
}

void check_program(const Program& program) {
  const Graph& graph = *program.graph;
  std::set<NodeId> provided;
  check_kernel(program.initial, graph, provided);
  check_kernel(program.prepare, graph, provided);
  provided.insert(program.prepare.provides.begin(), program.prepare.provides.end());
  check_kernel(program.time, graph, provided);
  provided.insert(program.time.provides.begin(), program.time.provides.end());
  for (const Kernel* kernel :
       {&program.rates, &program.constraint_errors, &program.energy, &program.outputs, &program.applied_forces}) {
    check_kernel(*kernel, graph, provided);
  }
  for (const Kernel& kernel : program.island_rows) {
    check_kernel(kernel, graph, provided);
  }
  std::set<NodeId> read;
  for (const Kernel* kernel : {&program.time, &program.rates, &program.constraint_errors, &program.energy,
                               &program.outputs, &program.applied_forces}) {
    const std::set<NodeId> purposes = purposes_of(*kernel);
    read.insert(purposes.begin(), purposes.end());
    for (const NodeId id : order_of(*kernel)) {
      read.insert(graph[id].used_operands().begin(), graph[id].used_operands().end());
    }
  }
  for (const Kernel& kernel : program.island_rows) {
    const std::set<NodeId> purposes = purposes_of(kernel);
    read.insert(purposes.begin(), purposes.end());
    for (const NodeId id : order_of(kernel)) {
      read.insert(graph[id].used_operands().begin(), graph[id].used_operands().end());
    }
  }
  for (const NodeId id : provided) {
    REQUIRE(read.contains(id));  // or it would be provided in vain
  }
}

std::size_t operations(const Kernel& kernel) { return order_of(kernel).size(); }

Program program_of(const std::string& text) { return std::move(*test::compiled(text).program); }

}  // namespace

TEST_CASE("programs of random scenes are in order, without dead code, and every value is at its level") {
  Random random(1);
  int programs = 0;
  while (programs < 150) {
    Compilation compilation = compile("scene.mbd", test::RandomScene(random).text(), {});
    if (compilation.program) {
      ++programs;
      INFO(compilation.sources[0].text());
      check_program(*compilation.program);
    }
  }
}

TEST_CASE("so are programs of repetitive scenes") {
  for (const std::string& text :
       {test::chain(40), test::wheel(30), test::net(6), test::cluster(12), test::springs(50)}) {
    check_program(program_of(text));
  }
}

TEST_CASE("what depends on parameters or time alone is computed once per run or per time") {
  const Program program = program_of(R"(dimension 1
parameter k = 2
particle 1 { mass = 1; position = 0; force = sin(k)*x1 + cos(3*t)*x1 + exp(k*t) }
)");
  const auto computes = [&](const Kernel& kernel, graph::Operator op) {
    for (const NodeId id : order_of(kernel)) {
      if ((*program.graph)[id].op == op) {
        return true;
      }
    }
    return false;
  };
  CHECK(computes(program.prepare, graph::Operator::Sin));
  CHECK(computes(program.time, graph::Operator::Cos));
  CHECK(computes(program.time, graph::Operator::Exp));
  for (const graph::Operator op : {graph::Operator::Sin, graph::Operator::Cos, graph::Operator::Exp}) {
    CHECK_FALSE(computes(program.rates, op));
  }
  CHECK_FALSE(program.keeps_time);
}

TEST_CASE("a scene without constraints has no islands") {
  const Program program = program_of(test::cluster(3));
  CHECK(program.islands.empty());
  CHECK(program.rates.islands.empty());
  CHECK(program.island_rows.empty());
  CHECK(operations(program.constraint_errors) == 0);
}

TEST_CASE("constant rows are factorised when compiling, rows of parameters once per run") {
  const Program constant = program_of(R"(dimension 1
particle 1 { mass = 2; position = 0; force = -x1 }
particle 2 { mass = 3; position = 0 }
constraint : 2*x1 + x2 = 0
constraint : x1 - 3*x2 = 0
)");
  REQUIRE(constant.rates.islands.size() == 1);
  CHECK_FALSE(constant.rates.islands[0].solve.has_guards());
  for (const NodeId id : order_of(constant.rates)) {
    CHECK((*constant.graph)[id].op != graph::Operator::Divide);
  }
  const Program of_parameters = program_of(R"(dimension 1
parameter m = 2
particle 1 { mass = m; position = 0; force = -x1 }
particle 2 { mass = 3; position = 0 }
constraint : 2*x1 + x2 = 0
)");
  CHECK(operations(of_parameters.prepare) > 3);
  for (const NodeId id : order_of(of_parameters.rates)) {
    CHECK((*of_parameters.graph)[id].op != graph::Operator::Divide);
  }
}

TEST_CASE("more rows than speeds go to the pinv at once") {
  const Program program = program_of(R"(dimension 1
particle 1 { mass = 1; position = 1 }
particle 2 { mass = 1; position = 1 }
constraint : x1*x2 = 1
constraint : x1 - x2 = 0
constraint : x1^2 + x2^2 = 2
)");
  REQUIRE(program.rates.islands.size() == 1);
  CHECK(program.rates.islands[0].always_climbs);
}

TEST_CASE("ten particles at rest cost their own states, and a second copy of a scene costs what the first does") {
  const std::string scene = "particle a { mass = 1; position = (1, 0) }\nconstraint rod : norm(a.position) = 1\n";
  const std::string copy = "particle b { mass = 1; position = (1, 0) }\nconstraint bar : norm(b.position) = 1\n";
  const Program one = program_of("dimension 2\n" + scene);
  const Program with_others =
      program_of("dimension 2\n" + scene + "for i in 1..10 { particle p[i] { mass = 1; position = (i, 0) } }\n");
  CHECK(operations(with_others.rates) == operations(one.rates));
  CHECK(operations(program_of("dimension 2\n" + scene + copy).rates) == 2 * operations(one.rates));
}

TEST_CASE("a chain costs the same for every further link") {
  const auto cost = [](int links) { return operations(program_of(test::chain(links)).rates); };
  const std::size_t per_ten = cost(50) - cost(40);  // shorter ones are stored or eliminated in another order
  CHECK(cost(80) - cost(70) == per_ten);
  CHECK(cost(100) - cost(90) == per_ten);
  CHECK(cost(100) <= 12 * cost(10));
}

TEST_CASE("lowering keeps the values of random expressions") {
  Random random(2);
  for (int judged = 0; judged < 2000;) {
    Graph drawn, graph, lowered;
    std::vector<Expr> leaves;
    for (std::uint32_t i = 0; i < 4; ++i) {
      leaves.push_back(drawn.leaf(Kind::Coordinate, i));
    }
    test::RandomExpressions expressions(drawn, leaves, random);
    const auto folded = [&](const Node& node) {
      return node.kind == Kind::Constant ? graph.constant(node.value) : graph.leaf(node.kind, node.index);
    };
    const std::vector<Expr> roots =
        graph::evaluate<Expr>(drawn, std::array{expressions.draw(5), expressions.draw(5)}, folded);
    const std::array x = {random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)};
    const auto leaf = [&](const Node& node) {
      return Tracked(node.kind == Kind::Constant ? node.value : x[node.index]);
    };
    const Lowering lowering(roots, lowered);
    const std::vector<Tracked> before = graph::evaluate<Tracked>(graph, roots, leaf);
    const std::vector<Tracked> after = graph::evaluate<Tracked>(
        lowered, std::array{lowered.at(lowering(roots[0])), lowered.at(lowering(roots[1]))}, leaf);
    for (std::size_t i = 0; i < roots.size(); ++i) {
      if (test::is_sharp(before[i])) {
        ++judged;
        REQUIRE(std::abs(before[i].value - after[i].value) <= 4 * (before[i].error + after[i].error));
      }
    }
  }
}

TEST_CASE("integer powers become multiplications, shared denominators reciprocals") {
  Graph graph, lowered;
  const Expr a = graph.leaf(Kind::Coordinate, 0), b = graph.leaf(Kind::Coordinate, 1);
  const Expr p = graph.leaf(Kind::Parameter, 0);
  const std::vector<Expr> roots = {pow(a, graph.constant(5)),
                                   pow(a, graph.constant(-2)),
                                   pow(a, graph.constant(0.5)),
                                   sin(a) / b,
                                   cos(a) / b,
                                   exp(a) / b,
                                   a / p,
                                   sin(b) / exp(a)};
  const Lowering lowering(roots, lowered);
  const auto root = [&](std::size_t i) -> const Node& { return lowered[lowering(roots[i])]; };
  CHECK(root(0).op == graph::Operator::Multiply);
  CHECK(root(1).op == graph::Operator::Divide);
  CHECK(lowered[root(1).operands[1]].op == graph::Operator::Multiply);
  CHECK(root(2).op == graph::Operator::Power);
  for (const std::size_t shared : {std::size_t{3}, std::size_t{4}, std::size_t{5}}) {
    CHECK(root(shared).op == graph::Operator::Multiply);
  }
  CHECK(root(3).operands[1] == root(4).operands[1]);
  CHECK(root(6).op == graph::Operator::Multiply);  // 1/p is known before a
  CHECK(root(7).op == graph::Operator::Divide);    // one division stays
}

}  // namespace mbcc::program
