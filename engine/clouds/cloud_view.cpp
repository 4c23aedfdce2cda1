#include "engine/clouds/cloud_view.h"

#include <algorithm>
#include <cmath>

#include "engine/clouds/weather_noise.h"
#include "engine/core/angles.h"
#include "engine/core/random.h"

#define OFFING_GLSL "shaders/lib/clouds.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

double fraction(double x) { return x - std::floor(x); }

/// The mean wind there over that at 10 m: logarithmic to the top of the boundary layer at 1 km,
/// then growing slowly.
double wind_aloft(double height) {
  constexpr double kRoughness = 0.005;
  const double low =
      std::log(std::clamp(height, 10.0, 1000.0) / kRoughness) / std::log(10.0 / kRoughness);
  return low * (1.0 + 0.08 * std::max(height - 1000.0, 0.0) / 1000.0);
}

}  // namespace

glm::dvec2 turned(const glm::dvec2& v, double degrees) {
  const double c = std::cos(radians(degrees)), s = std::sin(radians(degrees));
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

glm::dvec3 pattern_place(const CloudView& view, const glm::dvec2& carried, double period,
                         std::uint64_t pattern) {
  const auto start = [&](std::uint64_t axis) {
    return random_uniform(view.seed, 200 + pattern, axis);
  };
  return {fraction((view.eye.x - carried.x) / period + start(0)),
          fraction(view.eye.y / period + start(1)),
          fraction((view.eye.z - carried.y) / period + start(2))};
}

glm::dvec2 cloud_carried(const CloudView& view, double height) {
  return turned(view.drift, view.parameters.direction_offset_deg) *
         (wind_aloft(height) * view.parameters.speed_factor);
}

glm::dvec2 cloud_velocity(const CloudView& view, double height) {
  CloudView unit = view;
  unit.drift = view.wind_to * view.wind_speed;
  return cloud_carried(unit, height);
}

double cloud_shear(const CloudView& view) {
  return view.parameters.shear * std::min(view.wind_speed / 8.0, 2.0);
}

double cloud_base(const CloudView& view) {
  // Stratus lies lower, and rain brings bases down.
  return view.parameters.base * glsl::cloud_blend(0.55, 1.0, 1.0, view.weather.type) *
         (1.0 - 0.35 * view.weather.precipitation);
}

glm::dvec2 weather_place(const CloudView& view) {
  const double period = kWeatherPeriod * view.parameters.scale;
  const glm::dvec3 at = pattern_place(view, cloud_carried(view, cloud_base(view)), period, 0);
  return {at.x, at.z};
}

glm::dvec2 rain_lag(const CloudView& view) {
  constexpr double kFall = 6.5;  // m/s: drops of 2 mm (Atlas, Srivastava & Sekhon 1973)
  const double base = cloud_base(view);
  return (cloud_velocity(view, base) - view.wind_speed * view.wind_to) * (base / kFall);
}

}  // namespace offing
