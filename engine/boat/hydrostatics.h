#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "engine/boat/hull_shape.h"

namespace offing {

inline constexpr double kWaterDensity = 1025.0;  ///< kg/m^3, sea water
inline constexpr double kAirDensity = 1.225;     ///< kg/m^3

/// The part of an outline that is under water.
struct WetSection {
  double area = 0.0;           ///< m^2
  glm::dvec2 centroid{0.0};    ///< m
  double breadth = 0.0;        ///< m, of its waterline
  double waterline_mid = 0.0;  ///< x of the middle of that waterline, m
};

/// Clips an outline by the half-plane where the depth d0 + gradient . (x, y) is positive.
WetSection wet_section(const HullSection& section, double d0, glm::dvec2 gradient);

/// A hull in flat water.
struct Immersion {
  double volume = 0.0;                ///< m^3
  glm::dvec3 centroid{0.0};           ///< of the volume, boat frame
  double waterplane = 0.0;            ///< m^2
  double flotation_z = 0.0;           ///< m, centre of the waterplane
  double transverse_inertia = 0.0;    ///< m^4 of the waterplane about the centreline
  double longitudinal_inertia = 0.0;  ///< m^4 about the centre of flotation
};

/// Upright, even keel, water at height y in the boat frame.
Immersion immerse_level(const HullShape& shape, double y);
/// Heeled by `heel` (rad, positive to starboard), even trim; water at depth such that the plane
/// stands `height` m above the boat's origin, measured along the vertical.
Immersion immerse_heeled(const HullShape& shape, double heel, double height);

}  // namespace offing
