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

int RigidBody::step(RigidBodyState& state, const Loads& loads, double dt) const {
  constexpr double kMostAcceleration = 80.0, kMostSpeed = 40.0, kMostRate = 15.0;
  int limits = 0;
  glm::dvec3 force = loads.force(), torque = loads.torque();
  glm::dvec3 damping = loads.damping(), angular_damping = loads.angular_damping();
  if (!finite(force) || !finite(torque) || !finite(damping) || !finite(angular_damping)) {
    force = torque = damping = angular_damping = glm::dvec3(0.0);
    ++limits;
  }

  // (M + A + dt D + dt m [w]x / 2) dv = dt (F - m w x v): the midpoint rule for the turning frame
  // keeps the kinetic energy of a force-free body to rounding.
  glm::dvec3 velocity = glm::conjugate(state.orientation) * state.velocity;
  const glm::dvec3 rate = state.angular_velocity;
  const glm::dvec3 total = mass + added_mass + dt * damping;
  const glm::dvec3 spin = 0.5 * dt * mass * rate;
  const glm::dmat3 matrix(glm::dvec3(total.x, spin.z, -spin.y),
                          glm::dvec3(-spin.z, total.y, spin.x),
                          glm::dvec3(spin.y, -spin.x, total.z));
  glm::dvec3 acceleration = glm::inverse(matrix) * (force - mass * glm::cross(rate, velocity));
  const glm::dvec3 angular = inertia + added_inertia;
  glm::dvec3 angular_acceleration =
      (torque - glm::cross(rate, angular * rate)) / (angular + dt * angular_damping);
  limits += limit(acceleration, kMostAcceleration);
  limits += limit(angular_acceleration, kMostAcceleration);

  velocity += dt * acceleration;
  state.angular_velocity += dt * angular_acceleration;
  limits += limit(velocity, kMostSpeed);
  limits += limit(state.angular_velocity, kMostRate);

  const glm::dvec3 turn = dt * state.angular_velocity;
  const double angle = glm::length(turn);
  // sin(x/2)/x, by its series where the quotient would lose digits
  const double half_sinc = angle > 1e-6 ? std::sin(0.5 * angle) / angle : 0.5;
  const glm::dquat delta(std::cos(0.5 * angle), half_sinc * turn.x, half_sinc * turn.y,
                         half_sinc * turn.z);
  state.orientation = glm::normalize(state.orientation * delta);
  state.velocity = state.orientation * velocity;
  state.position += dt * state.velocity;
  return limits;
}

double RigidBody::kinetic_energy(const RigidBodyState& state) const {
  const glm::dvec3 v = glm::conjugate(state.orientation) * state.velocity;
  const glm::dvec3 w = state.angular_velocity;
  return 0.5 * (glm::dot((mass + added_mass) * v, v) + glm::dot((inertia + added_inertia) * w, w));
}

}  // namespace offing
