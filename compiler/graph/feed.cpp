#include "graph/feed.hpp"

namespace mbcc::graph {

Feed Feed::constant(double value, std::size_t variables, Order order) {
  Feed feed;
  feed.value_ = value;
  feed.first_.resize(variables);
  feed.second_.resize(order == Order::Second ? variables * (variables + 1) / 2 : 0);
  return feed;
}

Feed Feed::variable(double value, std::size_t which, std::size_t variables, Order order) {
  Feed feed = constant(value, variables, order);
  feed.first_[which] = 1;
  return feed;
}

namespace {

std::size_t count(const std::array<const Feed*, 3>& operands) {
  std::size_t n = 0;
  while (n < operands.size() && operands[n] != nullptr) {
    ++n;
  }
  return n;
}

bool is_constant(const Feed& feed) {
  for (std::size_t i = 0; i < feed.variables(); ++i) {
    if (feed.first(i) != 0) {
      return false;
    }
  }
  return true;
}

}  // namespace

Feed Feed::chain(Operator op, const std::array<const Feed*, 3>& operands) {
  if (op == Operator::If) {
    return operands[0]->value_ != 0 ? *operands[1] : *operands[2];
  }
  const std::size_t n = count(operands);
  std::array<const double*, 3> values{};
  for (std::size_t a = 0; a < n; ++a) {
    values[a] = &operands[a]->value_;
  }
  Feed result = *operands[0];
  result.value_ = perform(op, values);
  std::fill(result.first_.begin(), result.first_.end(), 0.0);
  std::fill(result.second_.begin(), result.second_.end(), 0.0);

  for (std::size_t a = 0; a < n; ++a) {
    const Feed& outer = *operands[a];
    if (is_constant(outer) && outer.second_ == std::vector<double>(outer.second_.size())) {
      continue;  // as in Dual: x^c never meets ln x
    }
    const double slope_a = slope(op, a, result.value_, values);
    for (std::size_t i = 0; i < result.first_.size(); ++i) {
      result.first_[i] += slope_a * outer.first_[i];
    }
    for (std::size_t k = 0; k < result.second_.size(); ++k) {
      result.second_[k] += slope_a * outer.second_[k];
    }
  }
  if (result.second_.empty()) {
    return result;
  }
  // Curvatures d(slope_a)/d(operand b), from the slopes by forward differentiation.
  for (std::size_t b = 0; b < n; ++b) {
    if (is_constant(*operands[b])) {
      continue;
    }
    std::array<Dual<double>, 3> seeded{};
    std::array<const Dual<double>*, 3> seeds{};
    for (std::size_t a = 0; a < n; ++a) {
      seeded[a] = {operands[a]->value_, a == b ? 1.0 : 0.0};
      seeds[a] = &seeded[a];
    }
    const Dual<double> value = perform(op, seeds);
    for (std::size_t a = 0; a < n; ++a) {
      if (is_constant(*operands[a])) {
        continue;
      }
      const double curvature = slope(op, a, value, seeds).derivative;
      for (std::size_t i = 0; i < result.first_.size(); ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
          result.second_[packed(i, j)] += curvature * operands[a]->first_[i] * operands[b]->first_[j];
        }
      }
    }
  }
  return result;
}

}  // namespace mbcc::graph
