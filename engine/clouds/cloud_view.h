#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>

#include "engine/clouds/cloud_parameters.h"
#include "engine/environment/environment.h"

// What clouds are seen from and where they are, without any OpenGL.

namespace offing {

/// Lightning as it is seen now.
struct FlashView {
  glm::dvec2 away{0.0};  ///< from the eye to its place in the weather (x, z; m)
  double height = 0.0;   ///< over the bases, share of the tallest cloud
  double candela = 0.0;  ///< 0: none
};

/// What clouds are drawn from: the weather of now, and from where they are seen.
struct CloudView {
  Clouds weather;                ///< cover, type, precipitation, high
  glm::dvec2 drift{0.0};         ///< Environment::air_drift()
  glm::dvec2 wind_to{0.0, 1.0};  ///< unit (x, z)
  double wind_speed = 8.0;       ///< m/s at 10 m
  double elapsed = 0.0;          ///< s
  glm::dvec3 eye{0.0};           ///< the camera in the world, m
  std::uint64_t seed = 1;
  CloudParameters parameters;
  FlashView flash;
};

/// How far (x, z; m) and how fast (m/s) the wind at this height (m) carries clouds.
glm::dvec2 cloud_carried(const CloudView& view, double height);
glm::dvec2 cloud_velocity(const CloudView& view, double height);

/// How far the wind draws cloud along its way for each metre over the bases.
double cloud_shear(const CloudView& view);

/// Height of the bases in the mean, m over the sea.
double cloud_base(const CloudView& view);
/// Coordinates of the view's eye in the weather map, in periods.
glm::dvec2 weather_place(const CloudView& view);
/// How far rain from the bases lags behind its cloud at the sea, twice over (x, z; m): drops fall
/// into slower air, by the wind's difference at first and by nothing at the end.
glm::dvec2 rain_lag(const CloudView& view);

/// A vector turned by degrees, clockwise as a compass has it.
glm::dvec2 turned(const glm::dvec2& v, double degrees);
/// Texture coordinates (0 to 1) of the view's eye in a pattern of this period (m) that has been
/// `carried` along.
glm::dvec3 pattern_place(const CloudView& view, const glm::dvec2& carried, double period,
                         std::uint64_t pattern);

}  // namespace offing
