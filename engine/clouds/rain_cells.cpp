#include "engine/clouds/rain_cells.h"

#include <algorithm>
#include <cmath>

#include "engine/clouds/cloud_noise.h"
#include "engine/clouds/weather_noise.h"
#include "engine/core/random.h"

#define OFFING_GLSL "shaders/lib/clouds.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

/// One channel of the patterns between texels, 0 to 1, as a repeating texture gives it.
double pattern_at(const std::vector<std::uint8_t>& patterns, glm::dvec2 units, int channel) {
  constexpr int kTexels = CloudNoise::kWeatherTexels;
  const glm::dvec2 at = units * static_cast<double>(kTexels) - 0.5;
  const glm::dvec2 texel = glm::floor(at), share = at - texel;
  const auto value = [&](int i, int j) {
    const int x = (static_cast<int>(texel.x) + i) & (kTexels - 1);
    const int y = (static_cast<int>(texel.y) + j) & (kTexels - 1);
    return patterns[static_cast<std::size_t>(4 * (y * kTexels + x) + channel)] / 255.0;
  };
  return glm::mix(glm::mix(value(0, 0), value(1, 0), share.x),
                  glm::mix(value(0, 1), value(1, 1), share.x), share.y);
}

/// As clouds/weather.comp has it.
double rain_at(const std::vector<std::uint8_t>& patterns, const Clouds& weather,
               const WeatherOffsets& offsets, glm::dvec2 at) {
  const double cells = pattern_at(patterns, at + offsets.cells, 0);
  const double finer = pattern_at(patterns, 2.0 * glm::dvec2(at.y, at.x) + offsets.finer, 0);
  const double fronts = pattern_at(patterns, at + offsets.fronts, 1);
  const double rolls = pattern_at(
      patterns, glsl::weather_rolls(at) + glm::dvec2(offsets.finer.y, offsets.finer.x), 0);
  const double coverage =
      glsl::weather_coverage(glm::dvec4(cells, finer, fronts, rolls), weather.cover, weather.type);
  const double showers = pattern_at(patterns, at + offsets.patches, 3);
  return glsl::weather_rain(coverage, fronts, showers, weather.cover, weather.type,
                            weather.precipitation);
}

}  // namespace

double RainCells::at(const CloudView& view, double elapsed, glm::dvec2 place) const {
  if (rain_.empty()) return 0.0;
  const WeatherOffsets offsets = weather_offsets(view.seed, view.parameters.evolution * elapsed);
  return rain_at(patterns_, view.weather, offsets, place);
}

bool RainCells::update(const CloudView& view) {
  const bool raining = view.weather.precipitation > 0.0 && view.weather.cover > 0.0;
  const double time =
      view.parameters.evolution * kStep * std::floor(std::max(view.elapsed, 0.0) / kStep);
  const std::uint64_t key =
      raining ? hash_of(view.weather, time, view.seed, view.parameters.scale) : std::uint64_t{0};
  if (key == key_) return false;
  key_ = key;
  rain_.clear();
  if (!raining) return true;
  if (patterns_.empty()) patterns_ = make_weather_noise(CloudNoise::kWeatherTexels);
  period_ = kWeatherPeriod * view.parameters.scale;
  const WeatherOffsets offsets = weather_offsets(view.seed, time);
  rain_.reserve(static_cast<std::size_t>(kSize) * kSize);
  float most = 0.0f;
  for (int j = 0; j < kSize; ++j) {
    for (int i = 0; i < kSize; ++i) {
      const double rain = rain_at(patterns_, view.weather, offsets,
                                  (glm::dvec2(i, j) + 0.5) / static_cast<double>(kSize));
      rain_.push_back(static_cast<float>(rain));
      most = std::max(most, rain_.back());
    }
  }
  if (most <= 0.0f) rain_.clear();
  return true;
}

glm::dvec2 RainCells::corner(const CloudView& view) const {
  const glm::dvec2 eye(view.eye.x, view.eye.z);
  return eye - period_ * weather_place(view) - 0.5 * rain_lag(view);
}

glm::dvec2 RainCells::middle(const CloudView& view, std::size_t cell) const {
  const glm::dvec2 eye(view.eye.x, view.eye.z);
  const glm::dvec2 at = (glm::dvec2(cell % kSize, cell / kSize) + 0.5) * (period_ / kSize);
  const glm::dvec2 away = corner(view) + at - eye;
  return eye + away - period_ * glm::round(away / period_);
}

}  // namespace offing
