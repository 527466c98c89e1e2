// The open chains by MuJoCo: two hinges and a point mass for each link, its Runge-Kutta integrator of order 4 with a
// constant step. Loops are left out: MuJoCo closes them with soft constraints, which are another system.

#include <fmt/core.h>
#include <mujoco/mujoco.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>
#include <stdexcept>

#include "precision/peers/peer.hpp"

namespace bench::precision {

namespace {

/// MuJoCo asks for some inertia; this one changes the motion by its size at most.
constexpr const char* inertia = "1e-14 1e-14 1e-14";

/// Links hang along -z where all angles are 0; the first hinge of each turns about x, the second about y.
std::string model_text(std::size_t links) {
  std::string text = fmt::format(
      "<mujoco><option integrator='RK4' gravity='0 0 {}'><flag contact='disable' constraint='disable'/>"
      "</option><compiler boundinertia='0' balanceinertia='true'/><worldbody>",
      -gravity);
  for (std::size_t k = 0; k < links; ++k) {
    text += fmt::format(
        "<body pos='0 0 {}'><inertial pos='0 0 -1' mass='1' diaginertia='{}'/>"
        "<joint type='hinge' axis='1 0 0'/><joint type='hinge' axis='0 1 0'/>",
        k == 0 ? 0 : -1, inertia);
  }
  for (std::size_t k = 0; k < links; ++k) {
    text += "</body>";
  }
  return text + "</worldbody></mujoco>";
}

using Model = std::unique_ptr<mjModel, void (*)(mjModel*)>;
using Data = std::unique_ptr<mjData, void (*)(mjData*)>;

Model load(const std::string& text) {
  mju_user_warning = [](const char*) {
  };  // a motion that fails shows in its error; MuJoCo would keep a log in the folder
  char path[] = "/tmp/mbcc_mujoco_XXXXXX.xml";
  const int descriptor = mkstemps(path, 4);
  if (descriptor < 0) {
    throw std::runtime_error("no temporary file");
  }
  close(descriptor);
  std::ofstream(path) << text;
  char error[500] = "";
  Model model(mj_loadXML(path, nullptr, error, sizeof error), mj_deleteModel);
  std::remove(path);
  if (!model) {
    throw std::runtime_error(error);
  }
  return model;
}

/// All scenes that are open start with straight links; each link's angles are measured in the frame of the one before.
/// Angles from positions, rates from velocities by a Newton step on what MuJoCo itself says of the bodies.
void set_start(const mjModel& model, mjData& data, const HungChain& chain) {
  const int links = static_cast<int>(chain.masses.size());
  std::array<double, 3> before{}, speed_before{};
  for (int k = 0; k < links; ++k) {
    mj_kinematics(&model, &data);
    mj_comPos(&model, &data);
    const HungChain::Mass& mass = chain.masses[static_cast<std::size_t>(k)];
    double rod[3], local[3], spin[6] = {};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      rod[axis] = mass.position[axis] - before[axis];
    }
    const mjtNum* const frame = data.xmat + 9 * k;  // of the body before: bodies count from the world
    mju_mulMatTVec(local, frame, rod, 3, 3);
    // R_x(a) R_y(b) (0, 0, -1) = (-sin b, sin a cos b, -cos a cos b)
    const double b = std::asin(-local[0]), a = std::atan2(local[1], -local[2]);
    data.qpos[2 * k] = a;
    data.qpos[2 * k + 1] = b;
    mj_kinematics(&model, &data);
    mj_comPos(&model, &data);
    mj_comVel(&model, &data);
    mj_objectVelocity(&model, &data, mjOBJ_BODY, k, spin, 0);
    double carried[3], rate[3], turning[3];
    mju_cross(carried, spin, rod);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      turning[axis] = mass.velocity[axis] - speed_before[axis] - (k == 0 ? 0 : carried[axis]);
    }
    mju_mulMatTVec(rate, frame, turning, 3, 3);
    data.qvel[2 * k + 1] = -rate[0] / std::cos(b);
    data.qvel[2 * k] = (rate[1] * std::cos(a) + rate[2] * std::sin(a)) / std::cos(b);
    mj_comVel(&model, &data);
    before = mass.position;
    speed_before = mass.velocity;
  }
}

std::vector<Contender> contenders(const HungChain& chain) {
  if (chain.far_end || chain.masses.size() > 50) {
    return {};
  }
  const std::shared_ptr<mjModel> model = load(model_text(chain.masses.size()));
  std::vector<double> numbers;
  for (double steps = 64; steps < 2e6; steps *= 2) {
    numbers.push_back(steps);
  }
  return {{"MuJoCo, hinges", numbers, [model, &chain](double steps) {
             Data data(mj_makeData(model.get()), mj_deleteData);
             model->opt.timestep = chain.to / steps;
             set_start(*model, *data, chain);
             for (long i = std::lround(steps); i > 0; --i) {
               mj_step(model.get(), data.get());
             }
             mj_kinematics(model.get(), data.get());
             return watched(chain, [&](std::size_t mass, std::size_t axis) {
               const mjtNum* const at = data->xpos + 3 * (mass + 1);
               const mjtNum* const frame = data->xmat + 9 * (mass + 1);
               return at[axis] - frame[3 * axis + 2];
             });
           }}};
}

}  // namespace

}  // namespace bench::precision

int main(int argc, char** argv) { return bench::precision::run_peer(argc, argv, bench::precision::contenders); }
