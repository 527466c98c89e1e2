#pragma once
// The expression graph: every distinct expression exists once, so that equality is identity.

#include <array>
#include <cstdint>
#include <deque>
#include <span>
#include <unordered_map>
#include <vector>

#include "graph/operators.hpp"

namespace mbcc::graph {

/// How often a value has to be computed: once ever, once per run, once per time, once per state, once per order of the
/// Taylor series from a state.
enum class Level : std::uint8_t { Constant, Parameter, Time, State, Order };

enum class Kind : std::uint8_t {
  Constant,
  Parameter,
  Time,
  Coordinate,
  Speed,
  CoordinateRate,    ///< of energies, until what it stands for is put in
  CoordinateChange,  ///< along a direction: Note [tangent] in mechanics/tangent.hpp
  SpeedChange,
  Acceleration,
#define MBCC_SERIES_LEAF(name, meaning) name,
#include "graph/series_leaves.def"
  Apply
};

/// Rows of the operands of a series, which are leaves of neighbouring kinds; `array` is the first of them.
enum class Row : std::uint8_t { First, Before, Now, Next };
constexpr Kind row_of(Kind array, Row row) {
  return static_cast<Kind>(static_cast<std::uint8_t>(array) + static_cast<std::uint8_t>(row));
}
constexpr bool is_row(Kind kind) { return kind >= Kind::LeftFirst && kind <= Kind::SlowSquareNext; }

/// Leaves whose index tells what they are, not which of many.
constexpr bool is_scalar(Kind kind) {
  return kind == Kind::Time || kind == Kind::Order || kind == Kind::InverseOrder || kind == Kind::Impulse;
}

/// Index of a node; operands have smaller indices than the nodes that use them.
using NodeId = std::uint32_t;

struct Node {
  Kind kind = Kind::Constant;
  Operator op = Operator::Add;    ///< of Apply
  Level level = Level::Constant;  ///< the largest of the operands'
  std::uint32_t index = 0;        ///< of leaves of which there are several
  double value = 0;               ///< of Constant
  std::array<NodeId, 3> operands{};

  std::span<const NodeId> used_operands() const {
    return {operands.data(), kind == Kind::Apply ? static_cast<std::size_t>(arity(op)) : 0};
  }
};

class Graph;

/// A node of a graph as a value that can be computed with: the operators build further nodes of the same graph.
class Expr {
 public:
  Expr() = default;
  Expr(Graph& graph, NodeId id) : graph_(&graph), id_(id) {}

  Graph& graph() const { return *graph_; }
  NodeId id() const { return id_; }
  const Node& node() const;
  Level level() const { return node().level; }
  bool is_constant() const { return node().kind == Kind::Constant; }
  bool is_constant(double value) const { return is_constant() && node().value == value; }

  friend bool operator==(const Expr&, const Expr&) = default;
  friend auto operator<=>(const Expr& a, const Expr& b) { return a.id_ <=> b.id_; }

 private:
  Graph* graph_ = nullptr;
  NodeId id_ = 0;
};

class Graph {
 public:
  Graph() = default;
  Graph(const Graph&) = delete;
  Graph& operator=(const Graph&) = delete;

  Expr constant(double value);
  Expr leaf(Kind kind, std::uint32_t index = 0);

  /// The expression `op(operands)`, folded and in canonical form: Note [folding] in simplify.cpp.
  Expr apply(Operator op, std::span<const Expr> operands);
  /// The node exactly as asked for, except that it exists once.
  Expr intern(Operator op, std::span<const Expr> operands);

  /// Whether that node exists already.
  bool contains(Operator op, std::span<const Expr> operands) const;

  std::size_t size() const { return nodes_.size(); }
  const Node& operator[](NodeId id) const { return nodes_[id]; }
  Expr at(NodeId id) { return {*this, id}; }

 private:
  struct Hash {
    std::size_t operator()(const Node& node) const;
  };
  struct Same {
    bool operator()(const Node& a, const Node& b) const;
  };

  Node application(Operator op, std::span<const Expr> operands) const;
  Expr intern(const Node& node);

  std::vector<Node> nodes_;
  std::unordered_map<Node, NodeId, Hash, Same> ids_;
};

inline const Node& Expr::node() const { return (*graph_)[id_]; }

// clang-format off
#define MBCC_OPERATOR1(name, spelling, code, function, recurrence, slope_a) \
  inline Expr function(Expr a) { return a.graph().apply(Operator::name, std::array{a}); }
#define MBCC_OPERATOR2(name, spelling, code, function, recurrence, slope_a, slope_b) \
  inline Expr function(Expr a, Expr b) { return a.graph().apply(Operator::name, std::array{a, b}); }
#define MBCC_OPERATOR3(name, spelling, code, function, recurrence, slope_a, slope_b, slope_c) \
  inline Expr function(Expr a, Expr b, Expr c) { return a.graph().apply(Operator::name, std::array{a, b, c}); }
#include "graph/operators.def"
// clang-format on

inline Expr operator+(Expr a, Expr b) { return add(a, b); }
inline Expr operator-(Expr a, Expr b) { return subtract(a, b); }
inline Expr operator*(Expr a, Expr b) { return multiply(a, b); }
inline Expr operator/(Expr a, Expr b) { return divide(a, b); }
inline Expr operator-(Expr a) { return negate(a); }
inline Expr number(Expr like, double x) { return like.graph().constant(x); }
inline bool is_zero(Expr a) { return a.is_constant(0); }

/// Integer powers up to this one are multiplications, in their values and in their Taylor coefficients.
inline constexpr double largest_multiplied_exponent = 32;

/// The constant c of an expression c * rest in canonical form; 1 if there is none.
double numeric_factor(Expr x);

}  // namespace mbcc::graph
