#include "engine/sky/air_integral.h"

#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "engine/core/angles.h"
#include "engine/sky/air_reference.h"

#define OFFING_GLSL "shaders/lib/phase.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/scattering.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

using glm::dvec3;

constexpr double kLightRadius = 0.00465, kDarkest = -0.37;  // radians
constexpr double kLeast = 1e-30;                            // what a logarithm is taken of

/// Angle between the level and the sea's horizon.
double dip(double height_km) {
  return std::acos(glsl::kPlanetRadius / (glsl::kPlanetRadius + height_km));
}

/// What a ray of this zenith cosine meets after `along`.
struct Place {
  double height, up_x, up_y;  ///< the zenith there, in the plane of the ray
};
Place place_on(double height_km, double cosine, double along) {
  const double x = along * std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
  const double y = glsl::kPlanetRadius + height_km + along * cosine;
  const double radius = std::hypot(x, y);
  return {std::max(radius - glsl::kPlanetRadius, 0.0), x / radius, y / radius};
}

/// Distance to a sphere about the earth's middle: the way out of it, or in.
double to_sphere(double height_km, double cosine, double radius, bool enters) {
  const double r = glsl::kPlanetRadius + height_km, b = r * cosine;
  const double root = std::sqrt(std::max(b * b - r * r + radius * radius, 0.0));
  return enters ? -b - root : -b + root;
}

}  // namespace

double AirIntegral::Table::height(int row) const {
  const double y = row / (heights - 1.0);
  return glsl::kAirTop * y * y;
}

double AirIntegral::Table::angle(int column) const {
  const double from = -std::sqrt(below), to = std::sqrt(above);
  const double x = from + (to - from) * column / (angles - 1.0);
  return x * std::abs(x);
}

dvec3 AirIntegral::Table::at(double height_km, double angle) const {
  const double from = -std::sqrt(below), to = std::sqrt(above);
  const double root = std::copysign(std::sqrt(std::abs(angle)), angle);
  const double x = std::clamp((root - from) / (to - from), 0.0, 1.0) * (angles - 1);
  const double y = std::sqrt(std::clamp(height_km / glsl::kAirTop, 0.0, 1.0)) * (heights - 1);
  const int i = std::min(static_cast<int>(x), angles - 2);
  const int j = std::min(static_cast<int>(y), heights - 2);
  const dvec3* row = &values[static_cast<std::size_t>(j * angles + i)];
  const dvec3* next = row + angles;
  return glm::exp((1.0 - (y - j)) * (row[0] + (x - i) * (row[1] - row[0])) +
                  (y - j) * (next[0] + (x - i) * (next[1] - next[0])));
}

int AirIntegral::finely(int count) const {
  return std::max(static_cast<int>(std::lround(count * fineness_)), 2);
}

AirIntegral::AirIntegral(double haze, double fineness) : haze_(haze), fineness_(fineness) {
  const AirReference air(haze);
  depth_ = {finely(128), finely(256), 0.0, 0.5 * kPi + dip(glsl::kAirTop), {}};
  for (int row = 0; row < depth_.heights; ++row) {
    for (int column = 0; column < depth_.angles; ++column) {
      const double h = depth_.height(row);
      const double elevation = std::min(depth_.angle(column) - dip(h), 0.5 * kPi);
      const dvec3 t = air.transmittance(h, std::sin(elevation), 60);
      depth_.values.push_back(
          glm::log(glm::max(-glm::log(glm::max(t, dvec3(1e-300))), dvec3(kLeast))));
    }
  }
  often_ = {finely(32), finely(64), -kDarkest, 0.5 * kPi, {}};
  for (int row = 0; row < often_.heights; ++row) {
    for (int column = 0; column < often_.angles; ++column) {
      often_.values.push_back(glm::log(
          glm::max(often_scattered(often_.height(row), often_.angle(column)), dvec3(kLeast))));
    }
  }
}

/// From the light, as seen from a height: strips of its disc, as far as they stand above the sea.
dvec3 AirIntegral::light_at(double height_km, double cosine) const {
  const double above = std::asin(std::clamp(cosine, -1.0, 1.0)) + dip(height_km);
  if (above <= -kLightRadius) return dvec3(0.0);
  if (above > 5.0 * kLightRadius) return glm::exp(-depth_.at(height_km, above));
  const int strips = finely(12);
  dvec3 sum(0.0);
  double whole = 0.0;
  for (int i = 0; i < strips; ++i) {
    const double t = (2.0 * i + 1.0) / strips - 1.0, width = std::sqrt(1.0 - t * t);
    whole += width;
    const double strip = above + t * kLightRadius;
    if (strip > 0.0) sum += width * glm::exp(-depth_.at(height_km, strip));
  }
  return sum / whole;
}

/// Light scattered at least twice, as it arrives at a place from all sides on average: the second
/// order by integration over the sphere, later ones as a geometric series.
dvec3 AirIntegral::often_scattered(double height_km, double elevation) const {
  const int rises = finely(20), turns = finely(12), steps = finely(24);
  const glsl::Aerosol aerosol = glsl::aerosol_of_haze(haze_);
  const double horizon = -dip(height_km);
  dvec3 second(0.0), passed(0.0);
  for (int i = 0; i < rises * turns; ++i) {
    // Dense at the horizon and toward the light, each with the solid angle that it stands for.
    const double t = 1.0 - 2.0 * (i / turns + 0.5) / rises;
    const double range = t > 0.0 ? 0.5 * kPi - horizon : 0.5 * kPi + horizon;
    const double rise = horizon + range * t * std::abs(t);
    const double u = (i % turns + 0.5) / turns, azimuth = kPi * u * u;
    const double share = std::cos(rise) * range * std::abs(t) * (2.0 / rises) * (2.0 * u / turns);
    const double sine = std::sin(rise);
    const bool meets_sea = rise < horizon;
    const double length =
        meets_sea ? to_sphere(height_km, sine, glsl::kPlanetRadius, true)
                  : to_sphere(height_km, sine, glsl::kPlanetRadius + glsl::kAirTop, false);
    // The light in the frame of the ray's plane: across and up.
    const double across = std::cos(elevation) * std::cos(azimuth), up = std::sin(elevation);
    dvec3 through(share);
    for (int s = 0; s < steps; ++s) {
      const double x0 = s / static_cast<double>(steps), x1 = (s + 1.0) / steps;
      const double step = length * (x1 * x1 - x0 * x0);
      const Place place = place_on(height_km, sine, 0.5 * length * (x0 * x0 + x1 * x1));
      const glsl::Air air = glsl::air_at(aerosol, place.height);
      const dvec3 passes = glm::exp(-air.extinction * step);
      const dvec3 scattered = through * (air.rayleigh + air.mie) * (1.0 - passes) / air.extinction;
      second +=
          scattered * light_at(place.height, place.up_x * across + place.up_y * up) / (4.0 * kPi);
      passed += scattered;
      through *= passes;
    }
    if (meets_sea) {
      const Place place = place_on(height_km, sine, length);
      const double cosine = place.up_x * across + place.up_y * up;
      second += through * light_at(0.0, cosine) * std::max(cosine, 0.0) * (glsl::kSeaAlbedo / kPi);
    }
  }
  return second / (1.0 - passed);
}

dvec3 AirIntegral::radiance(double height_km, const dvec3& view, const dvec3& light) const {
  const int steps = finely(300);
  const glsl::Aerosol aerosol = glsl::aerosol_of_haze(haze_);
  const double towards = glm::dot(view, light);
  const double rayleigh = glsl::rayleigh_phase(towards);
  const double mie = glsl::cornette_shanks(glsl::kMieG, towards);
  const double length = to_sphere(height_km, view.y, glsl::kPlanetRadius + glsl::kAirTop, false);
  const dvec3 eye(0.0, glsl::kPlanetRadius + height_km, 0.0);
  dvec3 sum(0.0), through(1.0);
  for (int s = 0; s < steps; ++s) {
    const double x0 = s / static_cast<double>(steps), x1 = (s + 1.0) / steps;
    const double step = length * (x1 * x1 - x0 * x0);
    const dvec3 p = eye + 0.5 * length * (x0 * x0 + x1 * x1) * view;
    const double radius = glm::length(p), height = radius - glsl::kPlanetRadius;
    const double cosine = std::clamp(glm::dot(p, light) / radius, -1.0, 1.0);
    const glsl::Air air = glsl::air_at(aerosol, height);
    const dvec3 source = light_at(height, cosine) * (air.rayleigh * rayleigh + air.mie * mie) +
                         often_.at(height, std::asin(cosine)) * (air.rayleigh + air.mie);
    const dvec3 passes = glm::exp(-air.extinction * step);
    sum += through * source * (1.0 - passes) / air.extinction;
    through *= passes;
  }
  return sum;
}

}  // namespace offing
