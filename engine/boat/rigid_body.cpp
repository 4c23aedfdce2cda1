#include "engine/boat/rigid_body.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace offing {
namespace {

bool finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

int limit(glm::dvec3& v, double most) {
  const double length = glm::length(v);
  if (length <= most) return 0;
  v *= most / length;
  return 1;
}

/// Moves the pose on for dt seconds at steady velocities, in body axes.
void drift(RigidBodyState& state, double dt) {
  const glm::dvec3 velocity = glm::conjugate(state.orientation) * state.velocity;
  const glm::dvec3 turn = dt * state.angular_velocity;
  const double angle = glm::length(turn);
  // sin(x/2)/x, by its series where the quotient would lose digits
  const double half_sinc = angle > 1e-6 ? std::sin(0.5 * angle) / angle : 0.5;
  const glm::dquat delta(std::cos(0.5 * angle), half_sinc * turn.x, half_sinc * turn.y,
                         half_sinc * turn.z);
  state.orientation = glm::normalize(state.orientation * delta);
  state.velocity = state.orientation * velocity;
}

/// The share of a damping force that is taken at the end of the step: half where it is mild, which
/// is second order, all of it where it is stiff. x = dt damping / mass.
glm::dvec3 end_share(glm::dvec3 x) { return (1.0 + x) / (2.0 + x); }

}  // namespace

void Loads::add(glm::dvec3 force, glm::dvec3 arm) {
  force_ += force;
  torque_ += glm::cross(arm, force);
}

void Loads::add_damping(glm::dvec3 axis, glm::dvec3 arm, double coefficient, double speed) {
  add(axis * (-coefficient * speed), arm);
  const glm::dvec3 lever = glm::cross(arm, axis);
  damping_ += coefficient * axis * axis;
  angular_damping_ += coefficient * lever * lever;
}

void Loads::add_angular_damping(glm::dvec3 coefficients, glm::dvec3 rate) {
  torque_ -= coefficients * rate;
  angular_damping_ += coefficients;
}

RigidBodyState RigidBody::middle(const RigidBodyState& state, double dt) {
  RigidBodyState mid = state;
  mid.position += 0.5 * dt * state.velocity;
  drift(mid, 0.5 * dt);
  mid.velocity += mid.orientation * (0.5 * dt * state.acceleration);
  mid.angular_velocity += 0.5 * dt * state.angular_acceleration;
  return mid;
}

int RigidBody::step(RigidBodyState& state, const Loads& loads, double dt) const {
  constexpr double kMostAcceleration = 80.0, kMostSpeed = 40.0, kMostRate = 15.0;
  int limits = 0;
  glm::dvec3 force = loads.force(), torque = loads.torque();
  glm::dvec3 damping = loads.damping(), angular_damping = loads.angular_damping();
  if (!finite(force) || !finite(torque) || !finite(damping) || !finite(angular_damping)) {
    force = torque = damping = angular_damping = glm::dvec3(0.0);
    ++limits;
  }
  glm::dvec3 velocity = glm::conjugate(state.orientation) * state.velocity;
  const glm::dvec3 foretold = 0.5 * dt * state.acceleration;
  const glm::dvec3 rate = state.angular_velocity + 0.5 * dt * state.angular_acceleration;

  // The loads hold F(v*) - D (v - v*) about the foretold v*, with v between both ends of the step.
  // (M + A + dt s D + dt m [w]x / 2) dv = dt (F + D (v* - v) - m w x v): the midpoint rule for the
  // turning frame keeps the kinetic energy of a force-free body to rounding.
  const glm::dvec3 inert = mass + added_mass;
  const glm::dvec3 total = inert + dt * end_share(dt * damping / inert) * damping;
  const glm::dvec3 spin = 0.5 * dt * mass * rate;
  const glm::dmat3 matrix(glm::dvec3(total.x, spin.z, -spin.y),
                          glm::dvec3(-spin.z, total.y, spin.x),
                          glm::dvec3(spin.y, -spin.x, total.z));
  glm::dvec3 acceleration =
      glm::inverse(matrix) * (force + damping * foretold - mass * glm::cross(rate, velocity));
  const glm::dvec3 angular = inertia + added_inertia;
  glm::dvec3 angular_acceleration =
      (torque + angular_damping * (0.5 * dt * state.angular_acceleration) -
       glm::cross(rate, angular * rate)) /
      (angular + dt * end_share(dt * angular_damping / angular) * angular_damping);
  limits += limit(acceleration, kMostAcceleration);
  limits += limit(angular_acceleration, kMostAcceleration);

  state.position += 0.5 * dt * state.velocity;
  drift(state, 0.5 * dt);
  velocity += dt * acceleration;
  state.angular_velocity += dt * angular_acceleration;
  limits += limit(velocity, kMostSpeed);
  limits += limit(state.angular_velocity, kMostRate);
  state.velocity = state.orientation * velocity;
  drift(state, 0.5 * dt);
  state.position += 0.5 * dt * state.velocity;
  state.acceleration = acceleration;
  state.angular_acceleration = angular_acceleration;
  return limits;
}

double RigidBody::kinetic_energy(const RigidBodyState& state) const {
  const glm::dvec3 v = glm::conjugate(state.orientation) * state.velocity;
  const glm::dvec3 w = state.angular_velocity;
  return 0.5 * (glm::dot((mass + added_mass) * v, v) + glm::dot((inertia + added_inertia) * w, w));
}

}  // namespace offing
