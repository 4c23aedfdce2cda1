#pragma once
#include "engine/boat/hull.h"
#include "engine/boat/rigid_body.h"
#include "engine/boat/water_probe.h"
#include "engine/ocean/water_surface.h"

namespace offing {

/// What makes a floating thing of a shape, SI units.
struct FloatingBodyParameters {
  double mass = 50.0;                       ///< kg
  glm::dvec3 centre{0.0};                   ///< of the mass, in the shape's frame
  glm::dvec3 gyration{0.3};                 ///< m, about x, y, z
  glm::dvec3 added_mass{0.5, 0.8, 0.2};     ///< of the mass
  glm::dvec3 added_inertia{0.2, 0.2, 0.1};  ///< of the inertia
  HullDamping damping{
      .heave_per_area = 900.0, .cross_flow = 1.0, .munk = 0.0, .roll = 5.0, .yaw = 5.0};
  double drag_area = 0.2;  ///< m^2, drag coefficient times area against flow along z
};

/// A barrel of 200 l, a crate of 1.2 m, a raft of 3 by 2 m: shape and numbers.
struct FloatingThing {
  HullShape shape;
  FloatingBodyParameters parameters;
};
FloatingThing barrel();
FloatingThing crate();
FloatingThing raft();

/// Any rigid thing afloat, by the same hull forces as the boat. Owns its shape; no allocation per
/// step.
class FloatingBody {
 public:
  explicit FloatingBody(FloatingThing thing);

  /// At rest on the surface at a place (x, z), turned by `heading` (rad).
  void start(glm::dvec2 position, double heading, const WaterSurface& water, double time);
  /// One step of dt seconds, 1/30 or shorter.
  void step(const WaterSurface& water, double time, double dt);

  /// World place of the shape's origin, and the orientation.
  glm::dvec3 position() const { return motion_.position - motion_.orientation * p_.centre; }
  const glm::dquat& orientation() const { return motion_.orientation; }
  const RigidBodyState& motion() const { return motion_; }
  long limit_hits() const { return limits_ + probe_.limits(); }

 private:
  FloatingBodyParameters p_;
  Hull hull_;
  RigidBody body_;
  RigidBodyState motion_;
  WaterProbe probe_;
  HullMemory memory_;
  long limits_ = 0;
};

}  // namespace offing
