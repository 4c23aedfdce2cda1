#include "engine/boat/floating_body.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <utility>

#include "engine/core/angles.h"

namespace offing {

FloatingThing barrel() {
  FloatingThing thing{cylinder(0.88, 0.29), {}};
  thing.parameters.mass = 60.0;
  // What is left in it lies low: it has an up.
  thing.parameters.centre = {0.0, -0.08, 0.0};
  thing.parameters.gyration = {0.30, 0.30, 0.22};
  thing.parameters.damping.roll = 2.0;
  thing.parameters.damping.yaw = 2.0;
  return thing;
}

FloatingThing crate() {
  FloatingThing thing{box(1.2, 0.8, 0.7), {}};
  thing.parameters.mass = 180.0;
  thing.parameters.centre = {0.0, 0.28, 0.0};
  thing.parameters.gyration = {0.40, 0.42, 0.31};
  thing.parameters.damping.roll = 20.0;
  thing.parameters.damping.yaw = 20.0;
  thing.parameters.drag_area = 0.5;
  return thing;
}

FloatingThing raft() {
  FloatingThing thing{box(3.0, 2.0, 0.25), {}};
  thing.parameters.mass = 600.0;
  thing.parameters.centre = {0.0, 0.13, 0.0};
  thing.parameters.gyration = {0.88, 1.05, 0.60};
  thing.parameters.damping.roll = 150.0;
  thing.parameters.damping.yaw = 150.0;
  thing.parameters.drag_area = 0.4;
  return thing;
}

FloatingBody::FloatingBody(FloatingThing thing)
    : p_(thing.parameters), hull_(std::move(thing.shape), p_.damping) {
  body_.mass = p_.mass;
  body_.added_mass = p_.mass * p_.added_mass;
  body_.inertia = p_.mass * p_.gyration * p_.gyration;
  body_.added_inertia = body_.inertia * p_.added_inertia;
}

void FloatingBody::start(glm::dvec2 position, double heading, const WaterSurface& water,
                         double time) {
  motion_ = RigidBodyState{};
  motion_.orientation = glm::angleAxis(-heading, glm::dvec3(0.0, 1.0, 0.0));
  const double volume = p_.mass / kWaterDensity;
  double low = -3.0, high = 3.0;  // height of the water over the origin
  for (int i = 0; i < 50; ++i) {
    const double mid = 0.5 * (low + high);
    (immerse_level(hull_.shape(), mid).volume < volume ? low : high) = mid;
  }
  probe_.reset();
  memory_.reset();
  probe_.sample(hull_.shape(), {position.x, 0.0, position.y}, motion_.orientation, water, time,
                1.0);
  const double height = probe_.mean_height() - 0.5 * (low + high);
  motion_.position = glm::dvec3(position.x, height, position.y) + motion_.orientation * p_.centre;
  motion_.velocity = probe_.mean_velocity();
}

void FloatingBody::step(const WaterSurface& water, double time, double dt) {
  if (!(dt > 0.0)) return;
  const RigidBodyState last = motion_;
  motion_ = RigidBody::middle(last, dt);
  probe_.sample(hull_.shape(), position(), motion_.orientation, water, time + 0.5 * dt, dt);
  Loads loads;
  const glm::dquat body_from_world = glm::conjugate(motion_.orientation);
  loads.add(body_from_world * glm::dvec3(0.0, -p_.mass * kGravity, 0.0), glm::dvec3(0.0));
  const HullReading reading =
      hull_.add_loads(loads, body_, motion_, p_.centre, probe_, memory_, dt);
  const double wetness = std::min(1.0, reading.volume * kWaterDensity / p_.mass);
  const double along = (body_from_world * (motion_.velocity - probe_.mean_velocity())).z;
  loads.add_damping({0.0, 0.0, 1.0}, glm::dvec3(0.0),
                    0.5 * kWaterDensity * wetness * p_.drag_area * std::abs(along), along);
  const glm::dvec3 rate = motion_.angular_velocity;
  loads.add_angular_damping(glm::dvec3(wetness * p_.damping.roll, 0.0, 0.0), rate);
  motion_ = last;
  limits_ += body_.step(motion_, loads, dt);
}

}  // namespace offing
