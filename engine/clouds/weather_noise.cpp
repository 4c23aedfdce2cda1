#include "engine/clouds/weather_noise.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/core/angles.h"
#include "engine/core/random.h"

#define OFFING_GLSL "shaders/lib/noise.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/cloud_noise.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

double channel(int c, const glm::dvec3& at, int size) {
  switch (c) {
    case 0: {
      // Heaps of several sizes that stand in groups with clear lanes between them.
      const double cells = glsl::cellular_octaves({13, 3, 0.55, 2, 1.0}, at, size, 1);
      const double groups = glsl::gradient_octaves({4, 4, 0.5, 2, 0.0}, at, size, 2);
      return cells + 1.25 * groups;
    }
    case 1:
      return glsl::gradient_octaves({2, 4, 0.45, 2, 0.0}, at, size, 3);
    case 2:
      return glsl::gradient_octaves({7, 4, 0.55, 2, 0.0}, at, size, 4);
    default:
      return glsl::gradient_octaves({4, 2, 0.4, 2, 0.0}, at, size, 5);
  }
}

}  // namespace

std::vector<std::uint8_t> make_weather_noise(int size) {
  const auto count = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  std::vector<std::uint8_t> pixels(4 * count);
  std::vector<double> values(count);
  std::vector<std::uint32_t> order(count);
  for (std::size_t c = 0; c < 4; ++c) {
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        const glm::dvec3 at((x + 0.5) / size, (y + 0.5) / size, 0.5);
        values[static_cast<std::size_t>(y * size + x)] = channel(static_cast<int>(c), at, size);
      }
    }
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return values[a] < values[b]; });
    for (std::size_t rank = 0; rank < count; ++rank) {
      pixels[4 * order[rank] + c] = static_cast<std::uint8_t>(rank * 256 / count);
    }
  }
  return pixels;
}

WeatherOffsets weather_offsets(std::uint64_t seed, double time) {
  const auto offset = [&](std::uint64_t pattern, double speed) {
    const double way = kTau * random_uniform(seed, 100 + pattern, 2);
    const double moved = time * speed / kWeatherPeriod;
    const glm::dvec2 at(random_uniform(seed, 100 + pattern, 0) + moved * std::cos(way),
                        random_uniform(seed, 100 + pattern, 1) + moved * std::sin(way));
    return at - glm::floor(at);
  };
  return {offset(0, 0.6), offset(1, 1.1), offset(2, 1.6), offset(3, 0.3)};
}

}  // namespace offing
