#include "methods.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "any_dynamics.hpp"
#include "mbrt/dop853.hpp"
#include "mbrt/math.hpp"
#include "mbrt/radau.hpp"
#include "mbrt/rk4.hpp"
#include "mbrt/simulation.hpp"
#include "mbrt/taylor.hpp"

namespace mbrt {
namespace {

constexpr bool Constant = false, Chosen = true;
constexpr std::array entries = {
#define MBRT_METHOD(type, steps, description) MethodEntry{type::name, description, steps},
#include "methods.def"
};

template <class Method>
Course run(AnyDynamics& dynamics, std::vector<double>& state, const Task& task, Observer* observer) {
  if (observer == nullptr) {
    Unobserved nobody;
    return Method::run(dynamics, state, task, nobody);
  }
  Relay<std::vector<double>> relay(*observer);
  return Method::run(dynamics, state, task, relay);
}

/// A model that remembers the first of its evaluations whose rate is not finite.
struct StageProbe {
  using State = std::vector<double>;

  AnyModel& model;
  State state;
  double time = not_given;
  double now = 0;

  void set_time(double t) { model.set_time(now = t); }
  void rates(const State& y, State& rate) {
    model.rates(y, rate);
    if (std::isnan(time) && !all_finite(rate)) {
      time = now;
      state = y;
    }
  }
};

/// Goes on with a run that has shown its start already.
class Rest final : public Observer {
 public:
  explicit Rest(Observer& observer) : observer_(observer) {}

  void arriving() override { observer_.arriving(); }
  bool accepted(double time, std::span<const double> state, std::span<const double> rate,
                const Interpolant* between) override {
    const bool is_known = !std::exchange(has_begun_, true);
    return is_known || observer_.accepted(time, state, rate, between);
  }

 private:
  Observer& observer_;
  bool has_begun_ = false;
};

Course integrate_by(std::string_view method, AnyModel& model, const std::vector<Island>& islands,
                    const Options& options, const Task& task, std::vector<double>& state, Observer* observer) {
  const bool has_own_code = model.has_code_for(method) && !options.stabilization;
  if (has_own_code && (!task.project || model.can_project())) {
    return observer == nullptr ? model.integrate(method, task, state) : model.integrate(method, task, state, *observer);
  }
  AnyDynamics dynamics(model, islands, options.stabilization);
  Course course;
#define MBRT_METHOD(type, steps, description)            \
  if (method == type::name) {                            \
    course = run<type>(dynamics, state, task, observer); \
  }
#include "methods.def"
  return course;
}

/// `first` and what came after it.
Course joined(const Course& first, Course rest) {
  rest.steps += first.steps;
  rest.rejected += first.rejected;
  rest.evaluations += first.evaluations;
  rest.projections += first.projections;
  rest.stiff_from = first.stiff_from;
  return rest;
}

}  // namespace

std::span<const MethodEntry> methods() { return entries; }

const MethodEntry* find_method(std::string_view name) {
  const auto found =
      std::find_if(entries.begin(), entries.end(), [name](const MethodEntry& entry) { return name == entry.name; });
  return found == entries.end() ? nullptr : found;
}

Course integrate(AnyModel& model, const std::vector<Island>& islands, const Options& options, const Task& task,
                 std::vector<double>& state, Observer* observer) {
  Task first = task;
  first.leaves_stiff = options.chosen_by_auto && model.description().has_tangent;
  const Course course = integrate_by(options.method, model, islands, options, first, state, observer);
  if (course.ending != Ending::Stiff) {
    return course;
  }
  Task second = task;
  second.from = course.time;
  if (observer == nullptr) {
    return joined(course, integrate_by(Radau::name, model, islands, options, second, state, nullptr));
  }
  Rest rest(*observer);
  return joined(course, integrate_by(Radau::name, model, islands, options, second, state, &rest));
}

double find_failing_stage(AnyModel& model, double time, double step, std::span<double> state) {
  std::vector<double> y(state.begin(), state.end());
  StageProbe probe{model, y};
  Unobserved nobody;
  rk4(probe, y, {time, time + step, step, 1}, nobody);
  std::copy(probe.state.begin(), probe.state.end(), state.begin());
  model.set_time(std::isnan(probe.time) ? time : probe.time);
  return probe.time;
}

}  // namespace mbrt
