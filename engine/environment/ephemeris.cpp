#include "engine/environment/ephemeris.h"

#include <libnova/lunar.h>
#include <libnova/solar.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <iterator>
#include <mutex>

#include "engine/core/angles.h"

namespace offing {
namespace {

constexpr double kSecondsPerDay = 86400.0;
constexpr double kUnixEpochJd = 2440587.5;
constexpr double kKmPerAu = 149597870.7;
constexpr double kSunRadiusKm = 695700.0;
constexpr double kMoonRadiusKm = 1737.4;
/// Three hours: over four knots the cubic through the moon's path is off by 1e-6 degrees at most.
constexpr double kKnotSeconds = 10800.0;
/// Terms of ELP 2000-82 below this (radians) are left out: 0.0009 degrees at worst, and 25 times
/// faster than the whole series.
constexpr double kElpPrecision = 1e-6;

constexpr double arcseconds(double value) { return radians(value / 3600.0); }

/// Julian centuries of `jd` since J2000.
double centuries(double jd) { return (jd - 2451545.0) / 36525.0; }

glm::dmat3 rotate_x(double a) {  // takes a vector to axes turned by +a round x
  const double c = std::cos(a), s = std::sin(a);
  return glm::dmat3(1, 0, 0, 0, c, -s, 0, s, c);
}
glm::dmat3 rotate_y(double a) {
  const double c = std::cos(a), s = std::sin(a);
  return glm::dmat3(c, 0, s, 0, 1, 0, -s, 0, c);
}
glm::dmat3 rotate_z(double a) {
  const double c = std::cos(a), s = std::sin(a);
  return glm::dmat3(c, -s, 0, s, c, 0, 0, 0, 1);
}

/// Lieske 1979, in arc seconds (Meeus, Astronomical Algorithms, 22.2).
double mean_obliquity(double t) {
  return arcseconds(84381.448 + t * (-46.8150 + t * (-0.00059 + t * 0.001813)));
}

struct Nutation {
  double longitude, obliquity;  // radians
};

/// The largest terms of the IAU 1980 series (Meeus, table 22.A): to 0.02 arc seconds. Ours rather
/// than libnova's, which keeps the value of a call up to two hours away and so depends on history.
Nutation nutation(double t) {
  const double d = radians(297.85036 + 445267.111480 * t);
  const double m = radians(357.52772 + 35999.050340 * t);
  const double mm = radians(134.96298 + 477198.867398 * t);
  const double f = radians(93.27191 + 483202.017538 * t);
  const double o = radians(125.04452 - 1934.136261 * t);
  struct Term {
    double argument, longitude, obliquity;  // 0.0001 arc seconds
  };
  const Term terms[] = {{o, -171996.0 - 174.2 * t, 92025.0 + 8.9 * t},
                        {2 * (f - d + o), -13187.0 - 1.6 * t, 5736.0 - 3.1 * t},
                        {2 * (f + o), -2274.0, 977.0},
                        {2 * o, 2062.0, -895.0},
                        {m, 1426.0 - 3.4 * t, 54.0},
                        {mm, 712.0, -7.0},
                        {m + 2 * (f - d + o), -517.0, 224.0},
                        {2 * f + o, -386.0, 200.0},
                        {mm + 2 * (f + o), -301.0, 129.0},
                        {2 * (f - d + o) - m, 217.0, -95.0},
                        {mm - 2 * d, -158.0, 0.0},
                        {2 * (f - d) + o, 129.0, -70.0},
                        {2 * (f + o) - mm, 123.0, -53.0},
                        {2 * d, 63.0, 0.0},
                        {mm + o, 63.0, -33.0}};
  Nutation sum{0.0, 0.0};
  for (const Term& term : terms) {
    sum.longitude += term.longitude * std::sin(term.argument);
    sum.obliquity += term.obliquity * std::cos(term.argument);
  }
  return {arcseconds(sum.longitude * 1e-4), arcseconds(sum.obliquity * 1e-4)};
}

/// From the ecliptic and equinox of J2000 to the true equator and equinox of date: precession after
/// Lieske 1979 (Meeus 21.2), then nutation.
glm::dmat3 true_from_j2000_ecliptic(double t) {
  const double zeta = arcseconds(t * (2306.2181 + t * (0.30188 + t * 0.017998)));
  const double z = arcseconds(t * (2306.2181 + t * (1.09468 + t * 0.018203)));
  const double theta = arcseconds(t * (2004.3109 - t * (0.42665 + t * 0.041833)));
  const glm::dmat3 precession = rotate_z(-z) * rotate_y(theta) * rotate_z(-zeta);
  const Nutation n = nutation(t);
  const double obliquity = mean_obliquity(t);
  const glm::dmat3 nutate =
      rotate_x(-obliquity - n.obliquity) * rotate_z(-n.longitude) * rotate_x(obliquity);
  return nutate * precession * rotate_x(-mean_obliquity(0.0));
}

/// Turns the moon's own axes (x to the middle of its near side, z to its north) to the true equator
/// and equinox of date. Cassini's laws: its equator lies 1.54242 degrees to the ecliptic and
/// descends through it where the orbit ascends; it turns with the mean longitude (Meeus, chapter
/// 53).
glm::dmat3 equatorial_from_moon(double t) {
  constexpr double kInclination = radians(1.54242);
  const double f = radians(
      std::fmod(93.2720993 + t * (483202.0175273 + t * (-0.0034029 - t / 3526000.0)), 360.0));
  const double node =
      radians(std::fmod(125.0445550 + t * (-1934.1361849 + t * (0.0020762 + t / 467410.0)), 360.0));
  const Nutation n = nutation(t);
  const glm::dmat3 moon_from_ecliptic =
      rotate_z(f) * rotate_x(kInclination) * rotate_z(node + n.longitude + kPi);
  return rotate_x(-mean_obliquity(t) - n.obliquity) * glm::transpose(moon_from_ecliptic);
}

/// The earth's shadow at the moon, for geocentric places in km. Air makes it a fiftieth larger.
EarthShadow shadow_at_moon(const glm::dvec3& sun, const glm::dvec3& moon) {
  constexpr double kEarthKm = 6371.0 * 1.02;
  const double sun_distance = glm::length(sun);
  const glm::dvec3 along = -sun / sun_distance;
  const double behind = glm::dot(moon, along);
  EarthShadow shadow;
  if (behind <= 0.0) return shadow;  // on the sunny side there is none
  shadow.axis = (along * behind - moon) / kMoonRadiusKm;
  shadow.umbra = (kEarthKm - behind * (kSunRadiusKm - kEarthKm) / sun_distance) / kMoonRadiusKm;
  shadow.penumbra = (kEarthKm + behind * (kSunRadiusKm + kEarthKm) / sun_distance) / kMoonRadiusKm;
  return shadow;
}

/// Greenwich apparent sidereal time in radians (Meeus 12.4 and the equation of the equinoxes).
double greenwich_sidereal_time(double jd_ut, double t_tt) {
  const double t = centuries(jd_ut);
  const double mean =
      280.46061837 + 360.98564736629 * (jd_ut - 2451545.0) + t * t * (0.000387933 - t / 38710000.0);
  const Nutation n = nutation(t_tt);
  return wrap_tau(radians(std::fmod(mean, 360.0)) +
                  n.longitude * std::cos(mean_obliquity(t_tt) + n.obliquity));
}

/// The place on the WGS 84 ellipsoid, in km, x toward the meridian `sidereal`.
glm::dvec3 observer_km(double latitude, double sidereal) {
  constexpr double kEquatorKm = 6378.137;
  constexpr double kEccentricity2 = 0.00669437999014;
  const double s = std::sin(latitude), c = std::cos(latitude);
  const double n = kEquatorKm / std::sqrt(1.0 - kEccentricity2 * s * s);
  return {n * c * std::cos(sidereal), n * c * std::sin(sidereal), n * (1.0 - kEccentricity2) * s};
}

SkyPosition sky_position(const glm::dvec3& to_body, double radius, const glm::dmat3& world) {
  const double distance = glm::length(to_body);
  const glm::dvec3 d = world * (to_body / distance);
  SkyPosition p;
  p.azimuth_deg = degrees(wrap_tau(std::atan2(d.x, -d.z)));
  p.elevation_airless_deg = degrees(std::atan2(d.y, std::hypot(d.x, d.z)));
  p.elevation_deg = p.elevation_airless_deg + refraction_deg(p.elevation_airless_deg);
  p.radius_deg = degrees(std::asin(radius / distance));
  return p;
}

}  // namespace

glm::dvec3 SkyPosition::direction() const {
  const double a = radians(azimuth_deg), e = radians(elevation_deg);
  return {std::sin(a) * std::cos(e), std::sin(e), -std::cos(a) * std::cos(e)};
}

double refraction_deg(double h) {
  const auto saemundsson = [](double e) {
    return 1.02 / 60.0 / std::tan(radians(e + 10.3 / (e + 5.11)));
  };
  if (h >= -1.0) {
    // The formula leaves -0.03 arc seconds at the zenith; what is seen there is not bent at all.
    return std::max(saemundsson(std::min(h, 90.0)), 0.0);
  }
  if (h <= -4.0) return 0.0;
  // Cubic from the value and slope at -1 to nothing at -4.
  const double value = saemundsson(-1.0);
  const double slope = (saemundsson(-0.999) - saemundsson(-1.001)) / 0.002;
  const double s = (-1.0 - h) / 3.0;
  return value * (1.0 + s * s * (2.0 * s - 3.0)) - 3.0 * slope * s * (1.0 - s) * (1.0 - s);
}

double delta_t_seconds(double utc_seconds) {
  const double year = 1970.0 + utc_seconds / (365.2425 * kSecondsPerDay);
  // Values each decade to 1970, then each five years; 2100 to 2200 from the long-term parabola
  // -20 + 32 ((y - 1820) / 100)^2 to which the observed slowing is joined.
  struct Entry {
    double year, seconds;
  };
  static constexpr Entry kTable[] = {
      {1600, 120.0}, {1620, 98.0},  {1640, 73.0},  {1660, 48.0},  {1680, 26.0},  {1700, 9.0},
      {1720, 10.5},  {1740, 12.0},  {1760, 14.8},  {1780, 16.7},  {1800, 13.7},  {1820, 12.0},
      {1840, 5.7},   {1860, 7.9},   {1870, 1.6},   {1880, -5.4},  {1890, -5.9},  {1900, -2.7},
      {1910, 10.5},  {1920, 21.2},  {1930, 24.0},  {1940, 24.3},  {1950, 29.15}, {1955, 31.07},
      {1960, 33.15}, {1965, 35.73}, {1970, 40.18}, {1975, 45.48}, {1980, 50.54}, {1985, 54.34},
      {1990, 56.86}, {1995, 60.78}, {2000, 63.83}, {2005, 64.69}, {2010, 66.07}, {2015, 67.64},
      {2020, 69.36}, {2025, 69.13}, {2030, 70.0},  {2050, 80.0},  {2100, 130.0}, {2200, 442.0}};
  if (year <= kTable[0].year) return kTable[0].seconds;
  for (std::size_t i = 1; i < std::size(kTable); ++i) {
    if (year <= kTable[i].year) {
      const Entry &a = kTable[i - 1], &b = kTable[i];
      return a.seconds + (b.seconds - a.seconds) * (year - a.year) / (b.year - a.year);
    }
  }
  return kTable[std::size(kTable) - 1].seconds;
}

Ephemeris::Knot Ephemeris::evaluate(double utc_seconds) {
  const double jde = kUnixEpochJd + (utc_seconds + delta_t_seconds(utc_seconds)) / kSecondsPerDay;
  ln_helio_posn sun{};
  ln_rect_posn moon{};
  {
    static std::mutex libnova_keeps_static_caches;
    const std::lock_guard lock(libnova_keeps_static_caches);
    ln_get_solar_geom_coords(jde, &sun);
    ln_get_lunar_geo_posn(jde, &moon, kElpPrecision);
  }
  // Both come in the ecliptic and equinox of J2000, whatever libnova's own functions make of them.
  const double longitude = radians(sun.L) - arcseconds(20.4898 / sun.R);  // aberration
  const double latitude = radians(sun.B);
  const glm::dmat3 turn = true_from_j2000_ecliptic(centuries(jde));
  Knot knot;
  knot.sun_au =
      turn * (sun.R * glm::dvec3(std::cos(latitude) * std::cos(longitude),
                                 std::cos(latitude) * std::sin(longitude), std::sin(latitude)));
  // The moon's light takes 1.3 s, in which it moves by 0.7 arc seconds: left out.
  knot.moon_km = turn * glm::dvec3(moon.X, moon.Y, moon.Z);
  return knot;
}

CelestialState Ephemeris::at(double utc_seconds, double latitude_deg, double longitude_deg) {
  const double position = utc_seconds / kKnotSeconds;
  const long long first = static_cast<long long>(std::floor(position)) - 1;
  if (!filled_ || first != first_) {
    const auto old = knots_;
    for (long long i = 0; i < 4; ++i) {
      const long long from = filled_ ? first + i - first_ : -1;
      knots_[static_cast<std::size_t>(i)] =
          from >= 0 && from < 4 ? old[static_cast<std::size_t>(from)]
                                : evaluate(kKnotSeconds * static_cast<double>(first + i));
    }
    first_ = first;
    filled_ = true;
  }
  // Lagrange's cubic through the knots at -1, 0, 1 and 2.
  const double x = position - static_cast<double>(first + 1);
  const double weights[4] = {-x * (x - 1) * (x - 2) / 6, (x + 1) * (x - 1) * (x - 2) / 2,
                             -(x + 1) * x * (x - 2) / 2, (x + 1) * x * (x - 1) / 6};
  glm::dvec3 sun_km(0.0), moon_km(0.0);
  for (std::size_t i = 0; i < 4; ++i) {
    sun_km += weights[i] * kKmPerAu * knots_[i].sun_au;
    moon_km += weights[i] * knots_[i].moon_km;
  }

  const double jd = kUnixEpochJd + utc_seconds / kSecondsPerDay;
  const double t = centuries(jd + delta_t_seconds(utc_seconds) / kSecondsPerDay);
  const double latitude = radians(latitude_deg);
  const double sidereal = wrap_tau(greenwich_sidereal_time(jd, t) + radians(longitude_deg));

  CelestialState state;
  state.sidereal_time_h = sidereal * 12.0 / kPi;
  // Columns: where the equatorial axes point to in the world. Rows: east, up, south.
  const double c = std::cos(sidereal), s = std::sin(sidereal);
  const double cl = std::cos(latitude), sl = std::sin(latitude);
  state.world_from_equatorial = glm::dmat3(-s, cl * c, sl * c, c, cl * s, sl * s, 0.0, sl, -cl);

  state.world_from_j2000 =
      state.world_from_equatorial * true_from_j2000_ecliptic(t) * rotate_x(mean_obliquity(0.0));
  state.world_from_moon = state.world_from_equatorial * equatorial_from_moon(t);

  const glm::dvec3 observer = observer_km(latitude, sidereal);
  state.sun = sky_position(sun_km - observer, kSunRadiusKm, state.world_from_equatorial);
  state.moon = sky_position(moon_km - observer, kMoonRadiusKm, state.world_from_equatorial);
  state.sun_distance_au = glm::length(sun_km - observer) / kKmPerAu;
  state.moon_distance_km = glm::length(moon_km - observer);

  const glm::dvec3 moon_to_sun = glm::normalize(sun_km - moon_km);
  const double cos_phase = std::clamp(glm::dot(moon_to_sun, glm::normalize(-moon_km)), -1.0, 1.0);
  state.moon_phase_angle_deg = degrees(std::acos(cos_phase));
  state.moon_lit_fraction = 0.5 * (1.0 + cos_phase);
  state.sun_from_moon = state.world_from_equatorial * moon_to_sun;
  state.earth_shadow = shadow_at_moon(sun_km, moon_km);
  state.earth_shadow.axis = state.world_from_equatorial * state.earth_shadow.axis;
  return state;
}

CelestialState celestial_state(double utc_seconds, double latitude_deg, double longitude_deg) {
  return Ephemeris().at(utc_seconds, latitude_deg, longitude_deg);
}

}  // namespace offing
