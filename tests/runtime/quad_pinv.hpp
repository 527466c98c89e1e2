#pragma once
// The oracle of the rank ladder: minimum-norm least squares by a one-sided Jacobi SVD in quadruple precision, written
// for clarity and sharing nothing with what it judges.

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstddef>
#include <vector>

namespace mbrt::test {

using Quad = boost::multiprecision::cpp_bin_float_quad;
using QuadMatrix = std::vector<std::vector<Quad>>;  // rows

inline Quad dot(const std::vector<Quad>& a, const std::vector<Quad>& b) {
  Quad sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += a[i] * b[i];
  }
  return sum;
}

/// B = U S V^T, thin: rows of `directions` are the singular values times rows of V^T, rows of `rotation` those of U^T.
struct QuadSvd {
  QuadMatrix directions;
  QuadMatrix rotation;
  std::vector<Quad> singular_values;
};

/// One-sided Jacobi: turns pairs of rows of B until all are orthogonal.
inline QuadSvd svd(QuadMatrix b) {
  const std::size_t rows = b.size();
  QuadMatrix rotation(rows, std::vector<Quad>(rows, Quad(0)));
  for (std::size_t i = 0; i < rows; ++i) {
    rotation[i][i] = 1;
  }
  const auto turn = [](std::vector<Quad>& p, std::vector<Quad>& q, const Quad& c, const Quad& s) {
    for (std::size_t k = 0; k < p.size(); ++k) {
      const Quad old = p[k];
      p[k] = c * old - s * q[k];
      q[k] = s * old + c * q[k];
    }
  };
  for (bool turned = true; turned;) {
    turned = false;
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = i + 1; j < rows; ++j) {
        const Quad alpha = dot(b[i], b[i]), beta = dot(b[j], b[j]), gamma = dot(b[i], b[j]);
        if (gamma * gamma <= Quad(1e-64) * alpha * beta || gamma * gamma < Quad("1e-100")) {
          continue;
        }
        turned = true;
        const Quad zeta = (beta - alpha) / (2 * gamma);
        const Quad t = (zeta < 0 ? -1 : 1) / (abs(zeta) + sqrt(1 + zeta * zeta));
        const Quad c = 1 / sqrt(1 + t * t), s = c * t;
        turn(b[i], b[j], c, s);
        turn(rotation[i], rotation[j], c, s);
      }
    }
  }
  QuadSvd result{b, rotation, {}};
  for (const std::vector<Quad>& row : b) {
    result.singular_values.push_back(sqrt(dot(row, row)));
  }
  return result;
}

struct Truncated {
  std::vector<Quad> solution;  ///< w of minimum norm that minimises |B w - r|, B without its small singular values
  std::size_t rank;
  Quad largest, smallest_kept, largest_dropped;
};

/// Drops singular values up to cutoff * max(largest, 1).
inline Truncated truncated_pinv(const QuadMatrix& b, const std::vector<Quad>& r, double cutoff) {
  const QuadSvd decomposition = svd(b);
  const auto& sigma = decomposition.singular_values;
  const Quad largest = *std::max_element(sigma.begin(), sigma.end());
  const Quad smallest = cutoff * std::max(largest, Quad(1));
  Truncated result{std::vector<Quad>(b[0].size(), Quad(0)), 0, largest, largest, Quad(0)};
  for (std::size_t k = 0; k < sigma.size(); ++k) {
    if (sigma[k] <= smallest) {
      result.largest_dropped = std::max(result.largest_dropped, sigma[k]);
      continue;
    }
    ++result.rank;
    result.smallest_kept = std::min(result.smallest_kept, sigma[k]);
    const Quad weight = dot(decomposition.rotation[k], r) / (sigma[k] * sigma[k]);
    for (std::size_t j = 0; j < result.solution.size(); ++j) {
      result.solution[j] += weight * decomposition.directions[k][j];
    }
  }
  return result;
}

}  // namespace mbrt::test
