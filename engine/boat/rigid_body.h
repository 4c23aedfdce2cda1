#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace offing {

/// Where a body is and how it moves. Position and velocity are those of the centre of mass in the
/// world; the angular velocity is in body axes.
struct RigidBodyState {
  glm::dvec3 position{0.0};
  glm::dquat orientation{1.0, 0.0, 0.0, 0.0};  ///< world from body
  glm::dvec3 velocity{0.0};
  glm::dvec3 angular_velocity{0.0};
  /// Of the last step, body axes: what foretells the next one's middle.
  glm::dvec3 acceleration{0.0}, angular_acceleration{0.0};
};

/// Forces gathered over one step, in body axes about the centre of mass, with the diagonal of their
/// derivative against velocity, which is what makes damping implicit.
class Loads {
 public:
  void clear() { *this = Loads{}; }
  /// A force (N) at `arm` (m from the centre of mass).
  void add(glm::dvec3 force, glm::dvec3 arm);
  void add_torque(glm::dvec3 torque) { torque_ += torque; }
  /// A damping force -coefficient * speed along the unit vector `axis` at `arm`, where `speed` is
  /// the speed of that point along the axis relative to the fluid. coefficient in N s/m, >= 0.
  void add_damping(glm::dvec3 axis, glm::dvec3 arm, double coefficient, double speed);
  /// A damping moment; coefficients in N m s >= 0.
  void add_angular_damping(glm::dvec3 coefficients, glm::dvec3 rate);

  const glm::dvec3& force() const { return force_; }
  const glm::dvec3& torque() const { return torque_; }
  const glm::dvec3& damping() const { return damping_; }
  const glm::dvec3& angular_damping() const { return angular_damping_; }

 private:
  glm::dvec3 force_{0.0}, torque_{0.0}, damping_{0.0}, angular_damping_{0.0};
};

/// A rigid body with diagonal inertia and diagonal added mass.
///
/// Solves (M + A) dv/dt = F - m w x v and (I + A) dw/dt = T - w x (I + A) w in body axes (Fossen
/// 2011, "Handbook of Marine Craft Hydrodynamics", ch. 3) by drift, kick, drift (Hairer, Lubich &
/// Wanner 2006, "Geometric Numerical Integration", I.1.4): half a step of motion, then the loads
/// *there*, at velocities foretold by the last step's acceleration, then the other half. One
/// evaluation of the loads a step, second order in dt. Damping is implicit and cannot overshoot,
/// however stiff. The orientation moves by the exponential of the rotation vector.
class RigidBody {
 public:
  double mass = 1.0;              ///< kg
  glm::dvec3 added_mass{0.0};     ///< kg, along x, y, z of the body
  glm::dvec3 inertia{1.0};        ///< kg m^2 about x, y, z of the body
  glm::dvec3 added_inertia{0.0};  ///< kg m^2

  /// Where the body will be, and about how fast, in the middle of a step of dt seconds. The loads
  /// of the step are to be those of this state.
  static RigidBodyState middle(const RigidBodyState& state, double dt);
  /// The step itself. Returns how many limits were hit (accelerations beyond 80 m/s^2 or
  /// 80 rad/s^2, speeds beyond 40 m/s or 15 rad/s, a load that is not a number): 0 in honest work.
  int step(RigidBodyState& state, const Loads& loads_in_the_middle, double dt) const;

  /// Kinetic energy including that of the added mass, J.
  double kinetic_energy(const RigidBodyState& state) const;
};

}  // namespace offing
