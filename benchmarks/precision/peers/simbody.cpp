// The scenes by Simbody: point masses on joints (two angles each; rods that close a loop are constraints), and free
// point masses joined by rods, with Simbody's own Runge-Kutta-Merson integrator and projection.

#include <Simbody.h>

#include <cmath>
#include <limits>
#include <memory>

#include "precision/peers/peer.hpp"

namespace bench::precision {

namespace {

using SimTK::MobilizedBody;
using SimTK::Vec3;

Vec3 vec(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }

struct World {
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter{system};
  SimTK::GeneralForceSubsystem forces{system};
  SimTK::Force::Gravity gravity_force{forces, matter, Vec3(0, 0, -gravity)};
  std::vector<SimTK::MobilizedBodyIndex> bodies;
  SimTK::State start;

  const SimTK::MobilizedBody& body(std::size_t mass) const { return matter.getMobilizedBody(bodies[mass]); }

  std::vector<double> integrate(const HungChain& chain, double accuracy) const {
    SimTK::RungeKuttaMersonIntegrator integrator(system);
    integrator.setAccuracy(accuracy);
    integrator.setConstraintTolerance(std::min(accuracy, 1e-3));
    SimTK::TimeStepper stepper(system, integrator);
    stepper.initialize(start);
    stepper.stepTo(chain.to);
    const SimTK::State& end = integrator.getState();
    system.realize(end, SimTK::Stage::Position);
    return watched(chain, [&](std::size_t mass, std::size_t axis) {
      return body(mass).getBodyOriginLocation(end)[static_cast<int>(axis)];
    });
  }
};

/// The frame in which every scene stands away from the joints' singular positions: their second angle turns a rod
/// towards the first axis, which is y here.
const SimTK::Rotation joint_frame(SimTK::Pi / 2, SimTK::ZAxis);

std::shared_ptr<World> on_joints(const HungChain& chain) {
  auto world = std::make_shared<World>();
  const SimTK::Body::Rigid point(SimTK::MassProperties(1, Vec3(0), SimTK::Inertia(0)));
  Vec3 before(0);
  MobilizedBody* parent = &world->matter.updGround();
  for (const HungChain::Mass& mass : chain.masses) {
    const double length = (vec(mass.position) - before).norm();
    const SimTK::Transform inboard =
        world->bodies.empty() ? SimTK::Transform(joint_frame) : SimTK::Transform(SimTK::Rotation(), Vec3(0));
    MobilizedBody::Universal body(*parent, inboard, point, SimTK::Transform(Vec3(0, 0, length)));
    world->bodies.push_back(body.getMobilizedBodyIndex());
    parent = &world->matter.updMobilizedBody(world->bodies.back());
    before = vec(mass.position);
  }
  if (chain.far_end) {
    SimTK::Constraint::Rod(world->matter.updGround(), vec(*chain.far_end), *parent, Vec3(0),
                           (vec(*chain.far_end) - before).norm());
  }
  return world;
}

/// Angles and rates of the joints from positions and velocities of the masses, link by link.
void set_joints(World& world, const HungChain& chain) {
  world.system.realizeTopology();
  SimTK::State state = world.system.getDefaultState();
  Vec3 before(0), speed_before(0);
  for (std::size_t k = 0; k < chain.masses.size(); ++k) {
    const MobilizedBody& body = world.body(k);
    world.system.realize(state, SimTK::Stage::Velocity);
    const SimTK::Rotation parent = k == 0 ? joint_frame : world.body(k - 1).getBodyRotation(state);
    const Vec3 spin = k == 0 ? Vec3(0) : world.body(k - 1).getBodyAngularVelocity(state);
    const Vec3 rod = ~parent * (vec(chain.masses[k].position) - before).normalize();
    // The rod is -z of the body: R_x(q0) R_y(q1) (0, 0, -1) = (-sin q1, sin q0 cos q1, -cos q0 cos q1).
    const double q1 = std::asin(-rod[0]), q0 = std::atan2(rod[1], -rod[2]);
    body.setOneQ(state, 0, q0);
    body.setOneQ(state, 1, q1);
    const double length = (vec(chain.masses[k].position) - before).norm();
    const Vec3 turning = vec(chain.masses[k].velocity) - speed_before - spin % (vec(chain.masses[k].position) - before);
    const Vec3 rate = ~parent * turning / length;
    const double u1 = -rate[0] / std::cos(q1);
    const double u0 = (rate[1] * std::cos(q0) + rate[2] * std::sin(q0)) / std::cos(q1);
    body.setOneU(state, 0, u0);
    body.setOneU(state, 1, u1);
    before = vec(chain.masses[k].position);
    speed_before = vec(chain.masses[k].velocity);
  }
  world.system.realize(state, SimTK::Stage::Velocity);
  world.start = state;
}

std::shared_ptr<World> on_rods(const HungChain& chain) {
  auto world = std::make_shared<World>();
  const SimTK::Body::Rigid point(SimTK::MassProperties(1, Vec3(0), SimTK::Inertia(0)));
  Vec3 before(0);
  for (const HungChain::Mass& mass : chain.masses) {
    MobilizedBody::Translation body(world->matter.updGround(), SimTK::Transform(), point, SimTK::Transform());
    const double length = (vec(mass.position) - before).norm();
    MobilizedBody& last =
        world->bodies.empty() ? world->matter.updGround() : world->matter.updMobilizedBody(world->bodies.back());
    SimTK::Constraint::Rod(last, Vec3(0), body, Vec3(0), length);
    world->bodies.push_back(body.getMobilizedBodyIndex());
    before = vec(mass.position);
  }
  if (chain.far_end) {
    SimTK::Constraint::Rod(world->matter.updGround(), vec(*chain.far_end),
                           world->matter.updMobilizedBody(world->bodies.back()), Vec3(0),
                           (vec(*chain.far_end) - before).norm());
  }
  world->system.realizeTopology();
  world->start = world->system.getDefaultState();
  for (std::size_t k = 0; k < chain.masses.size(); ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      world->body(k).setOneQ(world->start, axis, chain.masses[k].position[static_cast<std::size_t>(axis)]);
      world->body(k).setOneU(world->start, axis, chain.masses[k].velocity[static_cast<std::size_t>(axis)]);
    }
  }
  world->system.realize(world->start, SimTK::Stage::Velocity);
  return world;
}

Contender contender(const char* name, const std::shared_ptr<World>& world, const HungChain& chain) {
  std::vector<double> accuracies;
  for (int decade = 2; decade <= 13; ++decade) {
    accuracies.push_back(std::pow(10, -decade));
  }
  return {name, accuracies, [world, &chain](double accuracy) {
            try {
              return world->integrate(chain, accuracy);
            } catch (const std::exception&) {  // Simbody says no in this way
              return std::vector<double>(chain.watched.size(), std::numeric_limits<double>::quiet_NaN());
            }
          }};
}

std::vector<Contender> contenders(const HungChain& chain) {
  std::vector<Contender> all;
  const std::shared_ptr<World> joints = on_joints(chain);
  set_joints(*joints, chain);
  all.push_back(contender("Simbody, joints", joints, chain));
  if (chain.masses.size() <= 50) {
    all.push_back(contender("Simbody, rods", on_rods(chain), chain));
  }
  return all;
}

}  // namespace

}  // namespace bench::precision

int main(int argc, char** argv) { return bench::precision::run_peer(argc, argv, bench::precision::contenders); }
