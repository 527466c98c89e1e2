#include "mbrt/stage_systems.hpp"

#include <Eigen/Dense>
#include <complex>
#include <vector>

namespace mbrt {
namespace {

using Index = Eigen::Index;

Index at(std::size_t i) { return static_cast<Index>(i); }

/// The components that remain, and those that follow.
struct Partition {
  Index component(Index r) const { return rest[static_cast<std::size_t>(r)]; }

  std::vector<Index> rest;
  std::vector<Index> place;  ///< in there, by component
  std::vector<Follower> followers;
};

/// The factors of s I - J without the followers: x_i = (b_i + x_l) / s of a follower i with the leader l.
template <class Scalar>
class Reduced {
 public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  explicit Reduced(Index size) : all_(size) {}

  void factorise(Scalar s, const Eigen::MatrixXd& jacobian, const Partition& parts) {
    shift_ = s;
    const Index size = at(parts.rest.size());
    matrix_.resize(size, size);
    for (Index c = 0; c < size; ++c) {
      for (Index r = 0; r < size; ++r) {
        matrix_(r, c) = -jacobian(parts.component(r), parts.component(c));
      }
      matrix_(c, c) += s;
    }
    for (const auto& [component, leader] : parts.followers) {
      for (Index r = 0; r < size; ++r) {
        matrix_(r, parts.place[leader]) -= jacobian(parts.component(r), at(component)) / s;
      }
    }
    factors_.compute(matrix_);
    right_.resize(size);
    solution_.resize(size);
  }

  /// all() becomes the solution for itself as the right side.
  void solve(const Eigen::MatrixXd& jacobian, const Partition& parts) {
    for (Index r = 0; r < right_.size(); ++r) {
      right_[r] = all_[parts.component(r)];
    }
    for (const Follower& follower : parts.followers) {
      const Scalar known = all_[at(follower.component)] / shift_;
      for (Index r = 0; r < right_.size(); ++r) {
        right_[r] += jacobian(parts.component(r), at(follower.component)) * known;
      }
    }
    solution_ = factors_.solve(right_);
    for (Index r = 0; r < right_.size(); ++r) {
      all_[parts.component(r)] = solution_[r];
    }
    for (const auto& [component, leader] : parts.followers) {
      all_[at(component)] = (all_[at(component)] + all_[at(leader)]) / shift_;
    }
  }

  Vector& all() { return all_; }

 private:
  Scalar shift_{};
  Vector all_, right_, solution_;
  Matrix matrix_;
  Eigen::PartialPivLU<Matrix> factors_;
};

}  // namespace

struct StageSystems::Matrices {
  explicit Matrices(Index size) : jacobian(size, size), real(size), pair(size) {
    parts.place.resize(static_cast<std::size_t>(size));
    parts.rest.reserve(parts.place.size());
    parts.followers.reserve(parts.place.size());
  }

  /// The component that row i says to be the rate of i: a single 1 beside the diagonal.
  Index leader_of(Index i) const {
    Index leader = -1;
    for (Index j = 0; j < jacobian.cols(); ++j) {
      if (jacobian(i, j) == 0) {
        continue;
      }
      if (jacobian(i, j) != 1 || leader >= 0 || j == i) {
        return -1;
      }
      leader = j;
    }
    return leader;
  }

  /// A leader does not follow itself.
  void find_followers() {
    parts.followers.clear();
    parts.rest.clear();
    for (Index i = 0; i < jacobian.rows(); ++i) {
      const Index leader = leader_of(i);
      if (leader >= 0 && leader_of(leader) < 0) {
        parts.followers.push_back({static_cast<std::size_t>(i), static_cast<std::size_t>(leader)});
      } else {
        parts.place[static_cast<std::size_t>(i)] = at(parts.rest.size());
        parts.rest.push_back(i);
      }
    }
  }

  Eigen::MatrixXd jacobian;
  Partition parts;
  Reduced<double> real;
  Reduced<std::complex<double>> pair;
};

StageSystems::StageSystems(std::size_t size) { matrices_.emplace_back(at(size)); }
StageSystems::StageSystems(StageSystems&&) noexcept = default;
StageSystems::~StageSystems() = default;

std::span<double> StageSystems::column(std::size_t j) {
  auto& jacobian = matrices_.front().jacobian;
  return {jacobian.col(at(j)).data(), static_cast<std::size_t>(jacobian.rows())};
}

bool StageSystems::take_jacobian() {
  matrices_.front().find_followers();
  return matrices_.front().jacobian.allFinite();
}

std::span<const Follower> StageSystems::followers() const { return matrices_.front().parts.followers; }

void StageSystems::factorise(double real, radau::Complex complex) {
  Matrices& m = matrices_.front();
  m.real.factorise(real, m.jacobian, m.parts);
  m.pair.factorise({complex.real, complex.imaginary}, m.jacobian, m.parts);
}

void StageSystems::solve(std::span<double> right) {
  Matrices& m = matrices_.front();
  const Eigen::Map<Eigen::VectorXd> values(right.data(), at(right.size()));
  m.real.all() = values;
  m.real.solve(m.jacobian, m.parts);
  std::copy(m.real.all().begin(), m.real.all().end(), right.begin());
}

void StageSystems::solve(std::span<double> real, std::span<double> imaginary) {
  Matrices& m = matrices_.front();
  auto& all = m.pair.all();
  for (std::size_t j = 0; j < real.size(); ++j) {
    all[at(j)] = {real[j], imaginary[j]};
  }
  m.pair.solve(m.jacobian, m.parts);
  for (std::size_t j = 0; j < real.size(); ++j) {
    const std::complex<double> value = all[at(j)];
    real[j] = value.real();
    imaginary[j] = value.imag();
  }
}

}  // namespace mbrt
