#pragma once
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <array>

namespace offing {

/// Where a body stands, topocentric.
struct SkyPosition {
  double azimuth_deg = 0.0;            ///< from north, eastward, 0 to 360
  double elevation_deg = 0.0;          ///< with refraction near the horizon
  double elevation_airless_deg = 0.0;  ///< without
  double radius_deg = 0.25;            ///< angular, as seen from the place
  /// Unit vector toward it (x east, y up, z south), with refraction.
  glm::dvec3 direction() const;
};

/// The earth's shadow where the moon is, in radii of the moon.
struct EarthShadow {
  glm::dvec3 axis{1e3, 0.0,
                  0.0};  ///< from the moon's centre to the nearest point of its axis, world
  double umbra = 2.6, penumbra = 4.7;  ///< radii
};

struct CelestialState {
  SkyPosition sun, moon;
  double moon_lit_fraction = 0.0;     ///< 0 new to 1 full, seen from the centre of the earth
  double moon_phase_angle_deg = 0.0;  ///< sun–moon–earth: 0 full, 180 new
  double sun_distance_au = 1.0;       ///< from the place
  double moon_distance_km = 384400.0;
  double sidereal_time_h = 0.0;  ///< apparent, local
  /// Turns equatorial coordinates of date (x to the equinox, z to the pole) to the world's axes
  /// (x east, y up, z south), without refraction.
  glm::dmat3 world_from_equatorial{1.0};
  /// The same for the mean equator and equinox of J2000: for the stars.
  glm::dmat3 world_from_j2000{1.0};
  /// Columns: where the middle of the moon's near side, its east and its north point to in the
  /// world (Cassini's laws: no physical libration, which stays below 0.05 degrees).
  glm::dmat3 world_from_moon{1.0};
  glm::dvec3 sun_from_moon{0.0, 1.0, 0.0};  ///< unit vector, world
  EarthShadow earth_shadow;
};

/// Sun and moon at `utc_seconds` since 1970-01-01 (UTC) seen from a place (degrees, north and east
/// positive) at sea level. Positions from libnova (VSOP87, ELP 2000-82), corrected for precession,
/// nutation, aberration, parallax and refraction (1010 hPa, 10 °C).
CelestialState celestial_state(double utc_seconds, double latitude_deg, double longitude_deg);

/// The same for a running clock: evaluates the long series only every three hours of the clock and
/// interpolates between (to 1e-6 degrees), so that a frame costs microseconds.
class Ephemeris {
 public:
  CelestialState at(double utc_seconds, double latitude_deg, double longitude_deg);

 private:
  /// Geocentric, in the true equator and equinox of date; astronomical units and km.
  struct Knot {
    glm::dvec3 sun_au, moon_km;
  };
  static Knot evaluate(double utc_seconds);
  std::array<Knot, 4> knots_;
  long long first_ = 0;  ///< number of the first knot, in steps since 1970
  bool filled_ = false;
};

/// Refraction in degrees to add to an airless elevation (Saemundsson 1986), smooth and fading to
/// nothing from 1 to 4 degrees below the horizon, where nobody can see.
double refraction_deg(double elevation_airless_deg);

/// TT − UT1 in seconds: observed until 2025, then drifting toward the long-term parabola
/// (Espenak & Meeus 2006; Morrison & Stephenson 2004).
double delta_t_seconds(double utc_seconds);

}  // namespace offing
