#include "graph/series.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "graph/dual.hpp"

using namespace mbcc::graph;

namespace {

constexpr std::size_t orders = 16;

/// Along q_i(t) = base_i + t/2 - t^2/4 + (i + 1) t^3/8, a motion none of whose low coefficients is zero.
struct Motion {
  std::vector<double> base;

  double coefficient(std::size_t i, std::size_t m) const {
    const std::array low{base[i], 0.5, -0.25, 0.125 * (static_cast<double>(i) + 1)};
    return m < low.size() ? low[m] : 0;
  }
};

std::vector<double> series_of(Graph& graph, Expr root, const Motion& motion, std::size_t last = orders) {
  const auto of_order = [&motion](std::size_t m) {
    return [&motion, m](const Node& node) { return motion.coefficient(node.index, m); };
  };
  Series series(graph, std::array{root}, of_order(0));
  for (std::size_t m = 1; m <= last; ++m) {
    series.advance(of_order(m));
  }
  return series.of(root);
}

/// Nested four deep: value and derivatives up to the fourth.
template <int Depth>
struct Nested {
  using Type = Dual<typename Nested<Depth - 1>::Type>;
  /// The series with coefficients c_k, from its derivative: d/dt has (k + 1) c_(k+1).
  static Type of(const std::vector<double>& c) {
    std::vector<double> derivative;
    for (std::size_t k = 1; k < c.size(); ++k) {
      derivative.push_back(static_cast<double>(k) * c[k]);
    }
    return {Nested<Depth - 1>::of(c), Nested<Depth - 1>::of(derivative)};
  }
  static double last(const Type& x) { return Nested<Depth - 1>::last(x.derivative); }
};
template <>
struct Nested<0> {
  using Type = double;
  static double of(const std::vector<double>& c) { return c.front(); }
  static double last(double x) { return x; }
};

template <int Depth>
double derivative_of(const Graph& graph, Expr root, const Motion& motion) {
  using Number = typename Nested<Depth>::Type;
  const auto leaf = [&](const Node& node) {
    std::vector<double> c;
    for (std::size_t m = 0; m <= Depth + 1; ++m) {
      c.push_back(node.kind == Kind::Constant ? (m == 0 ? node.value : 0) : motion.coefficient(node.index, m));
    }
    return Nested<Depth>::of(c);
  };
  return Nested<Depth>::last(evaluate<Number>(graph, std::array{root}, leaf).front());
}

/// Operands inside the domain of every operator and away from every switch.
Motion motion_for(Operator op) { return op == Operator::Acosh ? Motion{{1.7, 0.6, 0.4}} : Motion{{0.4, 0.7, 0.3}}; }

}  // namespace

TEST_CASE("the series of every operator is that of nested forward differentiation") {
  for (const OperatorRow& row : operator_table) {
    Graph graph;
    std::vector<Expr> operands;
    for (int i = 0; i < row.arity; ++i) {
      operands.push_back(graph.leaf(Kind::Coordinate, static_cast<std::uint32_t>(i)));
    }
    const Expr root = graph.intern(row.op, operands);
    const Motion motion = motion_for(row.op);
    INFO(row.name);
    const std::vector<double> c = series_of(graph, root, motion);
    // Four derivatives of functions of moderate size: some hundred roundings.
    const auto same = [](double derivative, double factorial) {
      return Approx(derivative / factorial).epsilon(1e-12).margin(1e-13);
    };
    CHECK(c[0] == same(derivative_of<0>(graph, root, motion), 1));
    CHECK(c[1] == same(derivative_of<1>(graph, root, motion), 1));
    CHECK(c[2] == same(derivative_of<2>(graph, root, motion), 2));
    CHECK(c[3] == same(derivative_of<3>(graph, root, motion), 6));
    CHECK(c[4] == same(derivative_of<4>(graph, root, motion), 24));
  }
}

TEST_CASE("powers have the series of the product or of the root that they are") {
  Graph graph;
  const Expr x = graph.leaf(Kind::Coordinate, 0);
  const Motion motion{{0.8}};
  const auto agree = [&](Expr a, Expr b) {
    const std::vector<double> of_a = series_of(graph, a, motion);
    const std::vector<double> of_b = series_of(graph, b, motion);
    for (std::size_t m = 0; m <= orders; ++m) {
      INFO("order " << m);
      // Coefficients grow like 0.8^-m while sums of them cancel: a few hundred roundings of the largest.
      CHECK(of_a[m] == Approx(of_b[m]).epsilon(1e-11).margin(1e-13));
    }
  };
  const auto power = [&](Expr base, double p) { return pow(base, graph.constant(p)); };
  agree(power(x, 5), x * x * x * x * x);
  agree(power(x, -3), graph.constant(1) / (x * x * x));
  agree(power(x, 0.5), sqrt(x));
  agree(power(x, 1.5), x * sqrt(x));
  agree(sin(x) / power(sqrt(x), 3), sin(x) * power(x, -1.5));
  agree(power(x, -1), exp(-log(x)));
}

TEST_CASE("series of elementary functions along t are the known ones") {
  Graph graph;
  const Expr t = graph.leaf(Kind::Time);
  const auto along_time = [&](Expr root) {
    const auto impulse = [](std::size_t m) { return [m](const Node&) { return m == 1 ? 1.0 : 0.0; }; };
    Series series(graph, std::array{root}, impulse(0));
    for (std::size_t m = 1; m <= orders; ++m) {
      series.advance(impulse(m));
    }
    return series.of(root);
  };
  const std::vector<double> exponential = along_time(exp(t));
  const std::vector<double> sine = along_time(sin(graph.constant(2) * t));
  const std::vector<double> geometric = along_time(graph.constant(1) / (graph.constant(1) - t));
  const std::vector<double> arc = along_time(atan(t));
  double factorial = 1;
  for (std::size_t m = 0; m <= orders; ++m) {
    const double n = static_cast<double>(m);
    factorial *= m == 0 ? 1 : n;
    const double sign = m / 2 % 2 == 0 ? 1 : -1;
    CHECK(exponential[m] == Approx(1 / factorial).epsilon(1e-14));
    CHECK(sine[m] == Approx(m % 2 == 0 ? 0 : sign * std::pow(2, n) / factorial).epsilon(1e-14));
    CHECK(geometric[m] == 1);
    CHECK(arc[m] == Approx(m % 2 == 0 ? 0 : sign / n).epsilon(1e-14));
  }
}

TEST_CASE("a switch keeps the side of its start, and the other side may leave its domain") {
  Graph graph;
  const Expr x = graph.leaf(Kind::Coordinate, 0);
  const Motion motion{{-0.5}};
  const std::vector<double> of_x = series_of(graph, x, motion);
  const std::vector<double> of_abs = series_of(graph, abs(x), motion);
  const std::vector<double> of_if = series_of(graph, select(less(x, graph.constant(0)), x * x, sqrt(x)), motion);
  const std::vector<double> of_square = series_of(graph, x * x, motion);
  for (std::size_t m = 0; m <= orders; ++m) {
    CHECK(of_abs[m] == -of_x[m]);
    CHECK(of_if[m] == of_square[m]);
  }
}
