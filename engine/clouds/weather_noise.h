#pragma once
#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

namespace offing {

/// What weather is mixed from: a tileable picture of `size`² texels of 4 bytes, row by row. Red:
/// cells and their clusters, green: fronts, blue and alpha: patches of middle and large size. Every
/// channel is evenly distributed over 0 … 255, so that a threshold is a share of the area.
std::vector<std::uint8_t> make_weather_noise(int size);

/// The weather repeats after this, m.
inline constexpr double kWeatherPeriod = 42000.0;

/// Where the patterns lie at a time (s): each wanders from a random place on its own way. In
/// periods.
struct WeatherOffsets {
  glm::dvec2 cells, finer, fronts, patches;
};
WeatherOffsets weather_offsets(std::uint64_t seed, double time);

}  // namespace offing
