#pragma once
#include <glm/vec2.hpp>

namespace offing {

/// Lift and drag coefficients.
struct FoilCoefficients {
  double lift = 0.0;  ///< positive for a positive angle of attack
  double drag = 0.0;
};

/// A low-aspect foil under the hull, its root sealed by it.
///
/// Lift slope 2 pi AR / (AR + 2) with AR = 2 span / chord (the hull mirrors it), induced drag
/// CL^2 / (0.9 pi AR) (Prandtl's lifting line with an Oswald factor), stall between 14 and 26
/// degrees into a flat plate, 2 sin a cos a and 2 sin^2 a, which holds at any angle of flow; stern
/// first the sharp edge leads and the slope is a fifth less (Hoerner 1985, "Fluid-Dynamic Lift").
class Foil {
 public:
  Foil(double span, double chord, double area) : area_(area), aspect_(2.0 * span / chord) {}

  double area() const { return area_; }
  double lift_slope() const;
  /// `angle` of attack in radians, any value.
  FoilCoefficients coefficients(double angle) const;
  /// Force in N in the plane (x to starboard, z aft), for water that moves past at `flow` m/s in
  /// that plane and a trailing edge turned by `deflection` rad to starboard.
  glm::dvec2 force(glm::dvec2 flow, double deflection) const;
  /// Angle (rad) by which the water behind it is turned when it meets a flow at `angle`: the
  /// lifting line's 2 CL / (pi AR) far behind, of which two thirds reach a rudder that is shorter
  /// than the keel and beside its wake. Half the leeway, as towing tanks find (Keuning, Katgert &
  /// Vermeulen 2007, "Further analysis of the forces on keel and rudder of a sailing yacht"). 0
  /// astern.
  double downwash(double angle) const;

 private:
  double area_, aspect_;
};

}  // namespace offing
