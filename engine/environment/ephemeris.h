#pragma once
#include <glm/vec3.hpp>

namespace offing {

/// Where a body stands, topocentric.
struct SkyPosition {
  double azimuth_deg = 0.0;            ///< from north, eastward, 0 to 360
  double elevation_deg = 0.0;          ///< with refraction near the horizon
  double elevation_airless_deg = 0.0;  ///< without
  /// Unit vector toward it (x east, y up, z south), with refraction.
  glm::dvec3 direction() const;
};

struct CelestialState {
  SkyPosition sun, moon;
  double moon_lit_fraction = 0.0;     ///< 0 new to 1 full
  double moon_phase_angle_deg = 0.0;  ///< sun–moon–earth: 0 full, 180 new
  double sidereal_time_h = 0.0;       ///< apparent, local
};

/// Sun and moon at `utc_seconds` since 1970-01-01 (UTC) seen from a place (degrees, north and east
/// positive) at sea level. Positions from libnova (VSOP87, ELP 2000-82), corrected for parallax,
/// aberration and refraction (1010 hPa, 10 °C).
CelestialState celestial_state(double utc_seconds, double latitude_deg, double longitude_deg);

}  // namespace offing
