#include "engine/clouds/lightning.h"

#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "engine/clouds/weather_map.h"
#include "engine/clouds/weather_noise.h"
#include "engine/core/random.h"

#define OFFING_GLSL "shaders/lib/phase.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/clouds.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/cloud_scattering.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

constexpr int kCells = 16;        // a side of the weather map: a storm's size each
constexpr double kWindow = 10.0;  // s that are drawn at once

/// Light of a stroke as a frame shows it. A return stroke sends out some 1e6 J of light (C. Guo &
/// E. P. Krider, "The Optical and Radiation Field Signatures Produced by Lightning Return Strokes",
/// JGR 87, 1982; first strokes several times that), near to 100 lm/W: 4e8 lm s over 4 pi and the
/// time it takes to fade here.
constexpr double kStroke = 1.0e9;      // cd, the first
constexpr double kFade = 0.035;        // s
constexpr double kGlow = 1000.0;       // m about the channel that glow most
constexpr double kHazeDepth = 1200.0;  // m, of the low air that holds most of the haze
constexpr double kBetween = 0.06;      // s between strokes, in the mean (Rakov & Uman 2003)

/// Number of a Poisson process of this mean that an even number (0 to 1) stands for.
int poisson(double mean, double share) {
  double each = std::exp(-mean), sum = each;
  int count = 0;
  while (share > sum && count < 64) sum += each *= mean / ++count;
  return count;
}

}  // namespace

double Flash::candela(double time) const {
  const int strokes = 1 + static_cast<int>(4.0 * random_uniform(key, 7, 0));
  double sum = 0.0, struck = begin;
  for (int i = 0; i < strokes; ++i) {
    const auto n = static_cast<std::uint64_t>(i);
    const double strength = i == 0 ? 1.0 : 0.25 + 0.5 * random_uniform(key, 8, n);
    const double age = time - struck;
    if (age >= 0.0) sum += strength * std::exp(-age / kFade);
    struck += kBetween * (0.5 + random_uniform(key, 9, n));
  }
  return time - begin < kLongest ? kStroke * sum : 0.0;
}

std::vector<Flash> flashes(const RainCells& rain, const CloudView& view, double from,
                           double until) {
  std::vector<Flash> found;
  const double rate = view.parameters.effects.lightning;
  if (rate <= 0.0 || !rain.any()) return found;
  const double side = kWeatherPeriod * view.parameters.scale / kCells;
  const double mean = rate / 60.0 * kWindow * side * side / 1.0e8;  // where all of it is storm
  for (double window = std::floor(from / kWindow); window * kWindow < until; ++window) {
    for (std::uint64_t cell = 0; cell < kCells * kCells; ++cell) {
      const std::uint64_t key =
          hash_of(view.seed, static_cast<std::int64_t>(window), cell, std::uint64_t{0x11});
      const int count = poisson(mean, random_uniform(key, 0, 0));
      for (int i = 0; i < count; ++i) {
        const auto n = static_cast<std::uint64_t>(i);
        Flash flash;
        flash.begin = (window + random_uniform(key, 1, n)) * kWindow;
        if (flash.begin < from || flash.begin >= until) continue;
        flash.at = (glm::dvec2(cell % kCells, cell / kCells) +
                    glm::dvec2(random_uniform(key, 2, n), random_uniform(key, 3, n))) /
                   static_cast<double>(kCells);
        flash.height = 0.1 + 0.5 * random_uniform(key, 4, n);
        flash.key = hash_of(key, n);
        // Thinned to what of a storm stands there.
        const double grown = glsl::storm_grown(view.weather.type, view.weather.precipitation,
                                               rain.at(view, flash.begin, flash.at));
        if (random_uniform(key, 5, n) < grown) found.push_back(flash);
      }
    }
  }
  return found;
}

FlashView flash_now(const RainCells& rain, const CloudView& view) {
  FlashView brightest;
  double most = 0.0;  // candela over distance squared
  const double period = kWeatherPeriod * view.parameters.scale;
  for (const Flash& flash :
       flashes(rain, view, view.elapsed - Flash::kLongest, view.elapsed + 1e-9)) {
    const double candela = flash.candela(view.elapsed);
    glm::dvec2 away = flash.at - weather_place(view);
    away = period * (away - glm::round(away));
    const double light = candela / (glm::dot(away, away) + kGlow * kGlow);
    if (light <= most) continue;
    most = light;
    brightest = {away, flash.height, candela};
  }
  return brightest;
}

glm::dvec3 flash_place(const CloudView& view) {
  const CloudParameters& p = view.parameters;
  const double over_bases =
      p.scale * (600.0 + view.flash.height * std::max(tallest_cloud(view.weather) - 600.0, 0.0));
  const double drawn =
      glsl::storm_drawn(over_bases, cloud_shear(view), tallest_storm(view.weather) * p.scale);
  const glm::dvec2 place = view.flash.away + turned(view.wind_to, p.direction_offset_deg) * drawn;
  return {place.x, cloud_base(view) + over_bases - view.eye.y, place.y};
}

FlashLight flash_light(const CloudView& view, const glm::dvec3& extinction) {
  FlashLight light;
  if (view.flash.candela <= 0.0) return light;
  const glm::dvec3 place = flash_place(view);
  const double distance = std::max(glm::length(place), kGlow);
  light.direction = glm::normalize(place);
  light.spread = 1.0 - distance / std::hypot(distance, kGlow);
  // The way through the low air, which thins out upward.
  const double high = std::max(std::abs(place.y), 1.0) / kHazeDepth;
  const glm::dvec3 air = glm::exp(-extinction * distance * (1.0 - std::exp(-high)) / high);
  // A cloud by itself shines to all sides; of a closed layer the lower face, which is seen at a
  // slant.
  const double slant = 2.0 * std::abs(light.direction.y);
  const double share = glm::mix(1.0, slant, view.weather.cover);
  light.illuminance = glsl::kFlashColour * air * share * view.flash.candela / (distance * distance);
  return light;
}

}  // namespace offing
