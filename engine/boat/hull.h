#pragma once
#include <glm/mat3x3.hpp>

#include <array>

#include "engine/boat/hydrostatics.h"
#include "engine/boat/rigid_body.h"
#include "engine/boat/water_probe.h"

namespace offing {

/// How a floating body meets the water, beside its shape.
struct HullDamping {
  double heave_per_area = 1400.0;  ///< N s/m per m^2 of waterplane: the waves it makes
  double heave_drag = 0.8;         ///< drag coefficient against vertical flow, on wet breadth
  double impact =
      0.33;  ///< of the half-disc's added mass that a slice gains as it enters the water
  double cross_flow = 0.6;  ///< drag coefficient against flow from the side, on wet side area
  double munk = 1.0;        ///< share of the ideal fluid's yawing moment that is left
  double roll = 700.0;      ///< N m s
  double yaw = 400.0;       ///< N m s
};

/// What a hull has to remember from step to step.
class HullMemory {
 public:
  void reset() { known_ = false; }

 private:
  friend class Hull;
  std::array<double, WaterProbe::kMostSlices> added_{};  ///< kg, of each slice afloat
  bool known_ = false;
};

/// What the water did to the hull this step.
struct HullReading {
  double volume = 0.0;       ///< m^3 under water
  glm::dvec3 buoyancy{0.0};  ///< N, world
  double slam = 0.0;         ///< N, of all slices that go in
};

/// Buoyancy and Froude-Krylov forces from slices clipped by the local water surface, and damping
/// relative to the water's own motion.
///
/// The pressure of a wave that is long against the draught is constant on its surface, so a slice
/// with the volume V under water feels rho V (g + a_vertical) up and -rho g V grad(h) along the
/// surface: the volume form of pressure times normal (Newman 1977, "Marine Hydrodynamics", 6.17).
/// Relative-motion added mass adds A a_water.
///
/// Slamming is momentum: a slice that goes in faster than the water gains the added mass dA of a
/// broader waterline and hands it its speed, F dt = w dA (von Karman 1929, NACA TN 321; half-disc
/// rho pi b^2 / 8 per metre, of which `impact` counts, as it does afloat). Coming out is free.
class Hull {
 public:
  Hull(HullShape shape, HullDamping damping) : shape_(std::move(shape)), damping_(damping) {}

  const HullShape& shape() const { return shape_; }
  /// Adds the loads about the centre of mass, which lies at `centre` in the boat frame.
  HullReading add_loads(Loads& loads, const RigidBody& body, const RigidBodyState& state,
                        const glm::dvec3& centre, const WaterProbe& water, HullMemory& memory,
                        double dt) const;

 private:
  HullShape shape_;
  HullDamping damping_;
};

}  // namespace offing
