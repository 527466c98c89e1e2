#include "random_model.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>

#include "graph/operators.hpp"
#include "program/roll.hpp"
#include "support/compiled.hpp"

namespace mbcc::test {

namespace {

constexpr std::array axes = {"x", "y", "z"};

/// Words that C++, its libraries or emitted code use, and names that mangling could make equal.
constexpr std::array words = {
    "class", "int",     "double",  "return",   "namespace", "auto",        "template",       "std",      "mbrt",
    "Model", "State",   "y",       "rate",     "rows",      "main",        "NULL",           "EOF",      "assert",
    "linux", "unix",    "i386",    "errno",    "_x",        "a_b",         "a__b",           "e1",       "s1",
    "c1",    "p1",      "t_",      "island",   "M_PI",      "I",           "safe",           "xor",      "not",
    "y_2",   "d_k",     "r_k",     "_Bool",    "double_",   "values",      "kinetic_energy", "outputs",  "added",
    "a_b_2", "climb_1", "signbit", "island_1", "new",       "parameters_", "constexpr",      "operator", "prepare"};

std::string exact(double x) { return std::signbit(x) ? fmt::format("({})", x) : fmt::format("{}", x); }

std::string tuple(const std::vector<std::string>& components) {
  return components.size() == 1 ? components[0] : fmt::format("({})", fmt::join(components, ", "));
}

}  // namespace

RandomModel::RandomModel(Random& random)
    : random_(random), dimension_(1 + random.below(3)), names_(words.begin(), words.end()) {
  random_.shuffle(names_);
  statements_.push_back("system " + declare());
  statements_.push_back(fmt::format("dimension {}", dimension_));
  draw_values();
  draw_particles();
  draw_loop();
  draw_definitions();
  if (!targets_.empty()) {
    draw_forces();
    draw_constraints();
  }
  draw_outputs();
  random_.shuffle(statements_);
  hold_at_start();
}

std::string RandomModel::text() const {
  std::string text = "# a random model\n";
  for (const std::string& statement : statements_) {
    text += statement + "\n";
  }
  for (const Constraint& constraint : constraints_) {
    text += fmt::format("{} : {} = {} + {}*t\n", constraint.heading, constraint.body, exact(constraint.value),
                        exact(constraint.rate));
  }
  return text;
}

std::string RandomModel::declare() {
  const std::string name = names_.back();
  names_.pop_back();
  return name;
}

void RandomModel::draw_values() {
  for (const char* kind : {"constant", "parameter", "parameter", "parameter"}) {
    if (random_.chance(0.5)) {
      values_.push_back(declare());
      statements_.push_back(fmt::format("{} {} = {}", kind, values_.back(),
                                        random_.chance(0.5) ? "sqrt(2)/3" : exact(random_.uniform(0.1, 3))));
    }
  }
}

void RandomModel::draw_particle(const std::string& name, const std::string& prefix, const std::string& suffix) {
  std::vector<std::string> position, velocity;
  for (std::size_t axis = 0; axis < dimension_; ++axis) {
    coordinates_.push_back(prefix + axes[axis] + suffix);
    speeds_.push_back(prefix + "v" + axes[axis] + suffix);
    accelerations_.push_back(speeds_.back() + "'");
    accelerations_.push_back(coordinates_.back() + "''");
    position.push_back(number());
    velocity.push_back(number());
  }
  targets_.push_back(name);
  statements_.push_back(fmt::format("particle {} {{ mass = {}; position = {}\n  velocity = {} }}", name,
                                    values_.empty() ? "2" : values_.front() + "^2 + 1", tuple(position),
                                    tuple(velocity)));
}

void RandomModel::draw_particles() {
  const std::size_t numbered = random_.below(3);
  for (std::size_t i = 1; i <= numbered; ++i) {
    draw_particle(std::to_string(i), "", std::to_string(i));
  }
  for (std::size_t i = random_.below(3); i > 0; --i) {
    const std::string name = declare();
    draw_particle(name, name + ".", "");
    if (dimension_ > 1) {
      vectors_.push_back(name + ".position");
      vectors_.push_back(name + ".velocity");
    }
  }
}

/// Particles name[i] on a line, at rest, one apart, and sometimes rods between them; a few, or as many as become loops.
void RandomModel::draw_loop() {
  if (random_.chance(0.5)) {
    return;
  }
  loop_ = declare();
  loop_size_ = random_.chance(0.2) ? program::shortest_run + 4 + random_.below(5) : 2 + random_.below(3);
  const std::string count = declare();
  const std::vector<std::string> along = {"i", "2*0", "0"};
  statements_.push_back(fmt::format("constant {} = {}", count, loop_size_));
  statements_.push_back(
      fmt::format("for i in 1..{} {{\n  particle {}[i] {{ mass = i/2; position = {}; force = {} }}\n}}", count, loop_,
                  tuple({along.begin(), along.begin() + static_cast<std::ptrdiff_t>(dimension_)}),
                  tuple(std::vector<std::string>(dimension_, fmt::format("-{}[i].vx", loop_)))));
  for (std::size_t i = 1; i <= loop_size_; ++i) {
    targets_.push_back(fmt::format("{}[{}]", loop_, i));
    coordinates_.push_back(targets_.back() + ".x");
    speeds_.push_back(targets_.back() + ".vx");
  }
  if (random_.chance(0.5)) {
    const std::string rod = dimension_ == 1 ? fmt::format("{0}[i + 1].x - {0}[i].x", loop_)
                                            : fmt::format("norm({0}[i + 1].position - {0}[i].position)^2", loop_);
    statements_.push_back(fmt::format("for i in 1..{} - 1 {{ constraint {}[i] : {} = 1 }}", count, declare(), rod));
  }
}

void RandomModel::draw_definitions() {
  if (random_.chance(0.5)) {
    const std::string name = declare();
    statements_.push_back(fmt::format("let {} = {}", name, expression(Of::Coordinates, 3)));
    values_.push_back(name);
  }
  if (vectors_.size() > 1 && random_.chance(0.5)) {
    const std::string name = declare();
    statements_.push_back(fmt::format("let {} = 2*{} -\n  {}/3", name, random_.pick(vectors_), random_.pick(vectors_)));
    vectors_.push_back(name);
  }
}

void RandomModel::draw_forces() {
  if (random_.chance(0.5)) {
    const std::vector<std::string> components = {"1", "-9.81", "0.5"};
    statements_.push_back("gravity " +
                          tuple({components.begin(), components.begin() + static_cast<std::ptrdiff_t>(dimension_)}));
  }
  for (std::size_t i = random_.below(4); i > 0; --i) {
    statements_.push_back(fmt::format("force on {} = {}", random_.pick(targets_), force()));
  }
}

std::string RandomModel::force() {
  std::vector<std::string> components;
  for (std::size_t axis = 0; axis < dimension_; ++axis) {
    components.push_back(expression(Of::Motion, 4));
  }
  return !vectors_.empty() && random_.chance(0.3) ? fmt::format("-{}*{}", leaf(Of::Motion), random_.pick(vectors_))
                                                  : tuple(components);
}

void RandomModel::draw_constraints() {
  for (std::size_t i = random_.below(3); i > 0; --i) {
    Constraint constraint;
    constraint.heading = random_.chance(0.7) ? "constraint " + declare() : "constraint";
    constraint.holonomic = random_.chance(0.6);
    const std::string& variable = random_.pick(constraint.holonomic ? coordinates_ : speeds_);
    constraint.body = fmt::format("2*{} + {}", variable, expression(Of::Coordinates, 3));
    constraints_.push_back(constraint);
  }
}

void RandomModel::draw_outputs() {
  for (std::size_t i = random_.below(4); i > 0; --i) {
    statements_.push_back(fmt::format("output {} = {}", declare(), expression(Of::Everything, 4)));
  }
  if (random_.chance(0.3)) {
    statements_.push_back(fmt::format("output {} = {}", declare(), nested(Of::Everything, 40)));
  }
  if (random_.chance(0.5)) {
    statements_.push_back("integrate { from = 0; to = 0.1; step = 0.01; method = rk4 }");
  }
}

std::string RandomModel::number() {
  static constexpr std::array written = {"1", "2.", ".5", "1e-3", "2.5E+1", "0", "3"};
  return random_.chance(0.5) ? random_.pick(written) : exact(random_.uniform(-2, 2));
}

std::string RandomModel::leaf(Of of) {
  const auto one_of = [&](const std::vector<std::string>& names) { return names.empty() ? "t" : random_.pick(names); };
  switch (random_.below(of == Of::Everything ? 9 : of == Of::Motion ? 8 : 6)) {
    case 0:
      return random_.chance(0.5) ? "t" : "pi";
    case 1:
      return number();
    case 2:
      return one_of(values_);
    case 6:
    case 7:
      return one_of(speeds_);
    case 8:
      return one_of(accelerations_);
    default:
      return one_of(coordinates_);
  }
}

std::string RandomModel::condition(Of of, int depth) {
  static constexpr std::array comparisons = {"<", "<=", ">", ">=", "==", "!="};
  return fmt::format("{} {} {}", expression(of, depth), random_.pick(comparisons), expression(of, depth));
}

/// A function of the language, with arguments inside its domain.
std::string RandomModel::application(Of of, int depth) {
  using graph::Operator;
  const graph::OperatorRow& row = random_.pick(graph::operator_table);
  const std::string a = expression(of, depth);
  if (!graph::find_function(row.spelling)) {
    return fmt::format("{} {} {}", a, random_.pick(std::array{"+", "-", "*"}), expression(of, depth));
  }
  switch (row.op) {
    case Operator::If:
      return fmt::format("if({}, {}, {})", condition(of, depth), a, expression(of, depth));
    case Operator::Asin:
    case Operator::Acos:
    case Operator::Atanh:
      return fmt::format("{}(0.9*sin({}))", row.spelling, a);
    case Operator::Acosh:
    case Operator::Sqrt:
    case Operator::Ln:
    case Operator::Log:
      return fmt::format("{}(1.5 + ({})^2)", row.spelling, a);
    case Operator::Exp:
    case Operator::Sinh:
    case Operator::Cosh:
    case Operator::Tan:
      return fmt::format("{}(cos({}))", row.spelling, a);
    default:
      return row.arity == 1 ? fmt::format("{}({})", row.spelling, a)
                            : fmt::format("{}({}, {})", row.spelling, a, expression(of, depth));
  }
}

std::string RandomModel::expression(Of of, int depth) {
  if (depth <= 0) {
    return leaf(of);
  }
  switch (random_.below(9)) {
    case 0:
      return fmt::format("({})^{}", expression(of, depth - 1), random_.pick(std::array{"2", "3", "1", "0", "5"}));
    case 1:
      return fmt::format("{}/(2 + sin({}))", leaf(of), expression(of, depth - 1));
    case 2:
      return fmt::format("(1 + ({})^2)^{}", expression(of, depth - 1),
                         random_.pick(std::array{"0.3", "(-1)", "-0.5", "-2"}));
    case 3:
      return vectors_.empty() || of == Of::Coordinates
                 ? leaf(of)
                 : fmt::format("{}*dot({}, {})", leaf(of), random_.pick(vectors_), random_.pick(vectors_));
    case 4:
      return loop_.empty() ? leaf(of)
                           : fmt::format("sum(j in 1..{}, if(j != 2, j*{}[j].x, {}))", loop_size_, loop_, leaf(of));
    case 5:
      return fmt::format("-({} - ({}))", expression(of, depth - 1), expression(of, depth - 1));
    case 6:
      return of == Of::Everything ? fmt::format("({})'", expression(Of::Motion, depth - 1)) : leaf(of);
    default:
      return application(of, depth - 1);
  }
}

std::string RandomModel::nested(Of of, int depth) {
  return depth == 0 ? leaf(of) : fmt::format("sin({} - ({}))", leaf(of), nested(of, depth - 1));
}

/// Takes from every constraint the value that it has at the start and, if it is holonomic, its rate.
void RandomModel::hold_at_start() {
  std::string measured = "# constraints as outputs\n";
  for (const std::string& statement : statements_) {
    measured += statement + "\n";
  }
  for (std::size_t k = 0; k < constraints_.size(); ++k) {
    measured += fmt::format("output measured_{} = {}\n", k, constraints_[k].body);
  }
  const Compilation c = compiled(measured, Stage::Equations);
  const mechanics::Point start = mechanics::initial_point(*c.system, c.equations);
  const std::vector<double> values = mechanics::values_at(start, c.equations.outputs);
  const std::vector<double> rates =
      mechanics::values_at(start, mechanics::rates_of(c.equations.outputs, c.equations.kinematics));
  const std::size_t first = values.size() - constraints_.size();
  for (std::size_t k = 0; k < constraints_.size(); ++k) {
    constraints_[k].value = values[first + k];
    constraints_[k].rate = constraints_[k].holonomic ? rates[first + k] : 0;
  }
}

}  // namespace mbcc::test
