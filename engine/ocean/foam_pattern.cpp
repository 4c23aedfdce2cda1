#include "engine/ocean/foam_pattern.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "engine/core/random.h"

namespace offing {
namespace {

/// Distance to the nearest of one random point per cell, in cells; repeats after `cells`.
double nearest_bubble(double x, double y, int cells, std::uint64_t seed) {
  const int cx = static_cast<int>(std::floor(x)), cy = static_cast<int>(std::floor(y));
  double nearest = 4.0;
  for (int j = cy - 1; j <= cy + 1; ++j) {
    for (int i = cx - 1; i <= cx + 1; ++i) {
      const auto wrapped = static_cast<std::uint64_t>(((j % cells + cells) % cells) * cells +
                                                      (i % cells + cells) % cells);
      const double dx = i + random_uniform(seed, wrapped, 0) - x;
      const double dy = j + random_uniform(seed, wrapped, 1) - y;
      nearest = std::min(nearest, dx * dx + dy * dy);
    }
  }
  return std::sqrt(nearest);
}

}  // namespace

gl::Texture make_foam_pattern(int size) {
  const auto count = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  std::vector<double> height(count);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      // Walls between bubbles of four sizes, warped a little so that no lattice shows.
      double sum = 0.0;
      const double u = static_cast<double>(x) / size, v = static_cast<double>(y) / size;
      const double wu =
          u + 0.03 * std::sin(6.283185307179586 * (v + std::sin(6.283185307179586 * u) * 0.3));
      const double wv = v + 0.03 * std::sin(6.283185307179586 * (u * 2.0 + 0.4));
      int cells = 5;
      for (std::uint64_t octave = 0; octave < 4; ++octave, cells = cells * 2 + 1) {
        const double weight = octave == 0 ? 1.1 : octave == 1 ? 1.0 : octave == 2 ? 0.7 : 0.4;
        sum += weight * nearest_bubble(wu * cells, wv * cells, cells, 77 + octave);
      }
      height[static_cast<std::size_t>(y * size + x)] = sum;
    }
  }
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return height[a] < height[b]; });
  std::vector<std::uint8_t> pixels(count);
  for (std::size_t rank = 0; rank < count; ++rank) {
    pixels[order[rank]] = static_cast<std::uint8_t>(rank * 256 / count);
  }
  // Floats, because a CPU renderer filters bytes more slowly.
  gl::Texture texture("sea.foam", {.format = GL_R32F,
                                   .width = size,
                                   .height = size,
                                   .levels = gl::full_mip_levels(size, size)});
  texture.upload(GL_RED, GL_UNSIGNED_BYTE, pixels.data());
  texture.generate_mipmaps();
  return texture;
}

}  // namespace offing
