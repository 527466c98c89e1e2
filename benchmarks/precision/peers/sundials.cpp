// The scenes by SUNDIALS: CVODE (Adams, fixed-point iteration) on the explicit equation, and IDA on the equations with
// multipliers, of index 1 (rods at acceleration level) and as Gear, Gupta and Leimkuhler stabilize them (rods at
// position and velocity level, multipliers left out of the error test), with banded Jacobians by differences.

#include <cvode/cvode.h>
#include <fmt/core.h>
#include <ida/ida.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_band.h>
#include <sunmatrix/sunmatrix_band.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <cmath>
#include <limits>

#include "precision/peers/peer.hpp"

namespace bench::precision {

namespace {

using Vec = std::array<double, 3>;

double dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec minus(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// A scene in blocks, one for each rod: r, v of the mass at its far end (which may be held), and multipliers.
struct Rods {
  const HungChain& chain;
  std::size_t count;
  std::size_t block;  ///< numbers in a block: 6 and the multipliers
  std::vector<double> squares;

  Rods(const HungChain& scene, std::size_t multipliers)
      : chain(scene), count(scene.masses.size() + (scene.far_end ? 1 : 0)), block(6 + multipliers) {
    const std::vector<double> start = this->start();
    for (std::size_t k = 0; k < count; ++k) {
      const Vec d = rod(start.data(), k, 0);
      squares.push_back(dot(d, d));
    }
  }

  bool is_held(std::size_t k) const { return k == chain.masses.size(); }
  std::size_t size() const { return count * block; }

  std::vector<double> start() const {
    std::vector<double> y(size());
    for (std::size_t k = 0; k < count; ++k) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        y[k * block + axis] = is_held(k) ? (*chain.far_end)[axis] : chain.masses[k].position[axis];
        y[k * block + 3 + axis] = is_held(k) ? 0 : chain.masses[k].velocity[axis];
      }
    }
    return y;
  }

  static Vec at(const double* y) { return {y[0], y[1], y[2]}; }
  /// Difference of r (part 0), of v (part 3) over a rod.
  Vec rod(const double* y, std::size_t k, std::size_t part) const {
    const Vec far = at(y + k * block + part);
    return k == 0 ? far : minus(far, at(y + (k - 1) * block + part));
  }

  /// Accelerations and tensions: a tridiagonal system, eliminated from the first rod on.
  void solve(const double* y, std::vector<Vec>& a, std::vector<double>& tension) const {
    std::vector<double> pivot(count), factor(count);
    tension.resize(count);
    a.resize(count);
    Vec before{};
    for (std::size_t k = 0; k < count; ++k) {
      const Vec d = rod(y, k, 0), w = rod(y, k, 3);
      pivot[k] = dot(d, d) * (k == 0 || is_held(k) ? 1 : 2);
      tension[k] = -dot(w, w) + (k == 0 ? gravity * d[2] : 0) - (is_held(k) ? gravity * d[2] : 0);
      if (k > 0) {
        const double coupling = -dot(d, before);
        factor[k] = coupling / pivot[k - 1];
        pivot[k] -= factor[k] * coupling;
        tension[k] -= factor[k] * tension[k - 1];
      }
      before = d;
    }
    for (std::size_t k = count; k-- > 0;) {
      tension[k] = tension[k] / pivot[k] - (k + 1 < count ? factor[k + 1] * tension[k + 1] : 0);
    }
    for (std::size_t k = 0; k < count; ++k) {
      a[k] = force(
          y, k, [&](std::size_t rod) { return tension[rod]; }, gravity);
    }
  }

  /// Weight and the pulls of the two rods on a mass; none on one that is held.
  template <class Multiplier>
  Vec force(const double* y, std::size_t k, const Multiplier& multiplier, double weight) const {
    Vec f{};
    if (is_held(k)) {
      return f;
    }
    const Vec d = rod(y, k, 0);
    const Vec next = k + 1 < count ? rod(y, k + 1, 0) : Vec{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      f[axis] = multiplier(k) * d[axis] - (k + 1 < count ? multiplier(k + 1) * next[axis] : 0);
    }
    f[2] -= weight;
    return f;
  }

  std::vector<double> end(const double* y) const {
    return watched(chain, [&](std::size_t mass, std::size_t axis) { return y[mass * block + axis]; });
  }
};

std::vector<double> failed(const HungChain& chain) {
  return std::vector<double>(chain.watched.size(), std::numeric_limits<double>::quiet_NaN());
}

/// What SUNDIALS allocates, freed in order.
struct Session {
  SUNContext context = nullptr;
  N_Vector y = nullptr, rate = nullptr, id = nullptr;

  explicit Session(std::size_t size) {
    SUNContext_Create(nullptr, &context);
    y = N_VNew_Serial(static_cast<sunindextype>(size), context);
    rate = N_VClone(y);
    id = N_VClone(y);
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session() {
    N_VDestroy(y);
    N_VDestroy(rate);
    N_VDestroy(id);
    SUNContext_Free(&context);
  }
};

void fill(N_Vector vector, const std::vector<double>& values) {
  std::copy(values.begin(), values.end(), N_VGetArrayPointer(vector));
}

constexpr long most_steps = 50000;

int explicit_rates(double, N_Vector y, N_Vector rate, void* user) {
  const Rods& rods = *static_cast<const Rods*>(user);
  static thread_local std::vector<Vec> a;
  static thread_local std::vector<double> tension;
  const double* const state = N_VGetArrayPointer(y);
  double* const out = N_VGetArrayPointer(rate);
  rods.solve(state, a, tension);
  for (std::size_t k = 0; k < rods.count; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      out[6 * k + axis] = state[6 * k + 3 + axis];
      out[6 * k + 3 + axis] = a[k][axis];
    }
  }
  return 0;
}

std::vector<double> by_cvode(const HungChain& chain, double tolerance) {
  Rods rods(chain, 0);
  Session session(rods.size());
  fill(session.y, rods.start());
  void* cvode = CVodeCreate(CV_ADAMS, session.context);
  CVodeInit(cvode, explicit_rates, 0, session.y);
  CVodeSStolerances(cvode, tolerance, tolerance);
  CVodeSetUserData(cvode, &rods);
  CVodeSetMaxNumSteps(cvode, most_steps);
  CVodeSetErrFile(cvode, nullptr);
  CVodeSetStopTime(cvode, chain.to);
  SUNNonlinearSolver iteration = SUNNonlinSol_FixedPoint(session.y, 0, session.context);
  CVodeSetNonlinearSolver(cvode, iteration);
  double t = 0;
  const int flag = CVode(cvode, chain.to, session.y, &t, CV_NORMAL);
  SUNNonlinSolFree(iteration);
  CVodeFree(&cvode);
  return flag < 0 ? failed(chain) : rods.end(N_VGetArrayPointer(session.y));
}

/// Block by block: r' = v (and in stabilized form + A^T mu), v' = g + A^T lambda, and the rods.
template <bool IsStabilized>
int residual(double, N_Vector y, N_Vector rate, N_Vector out, void* user) {
  const Rods& rods = *static_cast<const Rods*>(user);
  const double* const state = N_VGetArrayPointer(y);
  const double* const slope = N_VGetArrayPointer(rate);
  double* const left = N_VGetArrayPointer(out);
  for (std::size_t k = 0; k < rods.count; ++k) {
    const std::size_t at = k * rods.block;
    const Vec a = rods.force(
        state, k, [&](std::size_t rod) { return state[rod * rods.block + 6]; }, gravity);
    Vec shift{};
    if constexpr (IsStabilized) {
      shift = rods.force(
          state, k, [&](std::size_t rod) { return state[rod * rods.block + 7]; }, 0);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      left[at + axis] = slope[at + axis] - state[at + 3 + axis] - shift[axis];
      left[at + 3 + axis] = slope[at + 3 + axis] - a[axis];
    }
    const Vec d = rods.rod(state, k, 0), w = rods.rod(state, k, 3);
    if constexpr (IsStabilized) {
      left[at + 6] = 0.5 * (dot(d, d) - rods.squares[k]);
      left[at + 7] = dot(d, w);
    } else {
      left[at + 6] = dot(d, rods.rod(slope, k, 3)) + dot(w, w);
    }
  }
  return 0;
}

template <bool IsStabilized>
std::vector<double> by_ida(const HungChain& chain, double tolerance) {
  Rods rods(chain, IsStabilized ? 2 : 1);
  Session session(rods.size());
  std::vector<double> y = rods.start(), rate(y.size()), id(y.size());
  std::vector<Vec> a;
  std::vector<double> tension;
  rods.solve(y.data(), a, tension);
  for (std::size_t k = 0; k < rods.count; ++k) {
    const std::size_t at = k * rods.block;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      rate[at + axis] = y[at + 3 + axis];
      rate[at + 3 + axis] = a[k][axis];
      id[at + axis] = id[at + 3 + axis] = 1;
    }
    y[at + 6] = tension[k];
  }
  fill(session.y, y);
  fill(session.rate, rate);
  fill(session.id, id);
  void* ida = IDACreate(session.context);
  IDAInit(ida, residual<IsStabilized>, 0, session.y, session.rate);
  IDASStolerances(ida, tolerance, tolerance);
  IDASetUserData(ida, &rods);
  IDASetMaxNumSteps(ida, most_steps);
  IDASetErrFile(ida, nullptr);
  IDASetId(ida, session.id);
  IDASetSuppressAlg(ida, IsStabilized);
  IDASetStopTime(ida, chain.to);
  const auto band = static_cast<sunindextype>(std::min(2 * rods.block, rods.size()) - 1);
  SUNMatrix matrix = SUNBandMatrix(static_cast<sunindextype>(rods.size()), band, band, session.context);
  SUNLinearSolver solver = SUNLinSol_Band(session.y, matrix, session.context);
  IDASetLinearSolver(ida, solver, matrix);
  double t = 0;
  const int flag = IDASolve(ida, chain.to, &t, session.y, session.rate, IDA_NORMAL);
  SUNLinSolFree(solver);
  SUNMatDestroy(matrix);
  IDAFree(&ida);
  return flag < 0 ? failed(chain) : rods.end(N_VGetArrayPointer(session.y));
}

std::vector<Contender> contenders(const HungChain& chain) {
  const auto with = [&chain](const char* name, std::vector<double> (*integrate)(const HungChain&, double)) {
    return Contender{name, tolerances(), [&chain, integrate](double tolerance) { return integrate(chain, tolerance); }};
  };
  return {with("CVODE", by_cvode), with("IDA, index 1", by_ida<false>), with("IDA, stabilized", by_ida<true>)};
}

}  // namespace

}  // namespace bench::precision

int main(int argc, char** argv) { return bench::precision::run_peer(argc, argv, bench::precision::contenders); }
