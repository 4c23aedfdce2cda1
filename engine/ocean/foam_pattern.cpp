#include "engine/ocean/foam_pattern.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "engine/core/random.h"
#include "shaders/shared/foam.h"

namespace offing {
namespace {

using namespace shared;

constexpr double kMostDeviations = 3.2;  // on either side of a pattern's mean

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

/// A repeating square of values, read by straight lines between them.
class Pattern {
 public:
  Pattern(int size, std::vector<float> values) : size_(size), values_(std::move(values)) {}
  /// At a place in periods.
  double operator()(double x, double y) const {
    const double u = size_ * (x - std::floor(x)) - 0.5, v = size_ * (y - std::floor(y)) - 0.5;
    const double i = std::floor(u), j = std::floor(v);
    const auto row = [&](int z) {
      return std::lerp(at(static_cast<int>(i), z), at(static_cast<int>(i) + 1, z), u - i);
    };
    return std::lerp(row(static_cast<int>(j)), row(static_cast<int>(j) + 1), v - j);
  }
  const std::vector<float>& values() const { return values_; }

 private:
  double at(int x, int y) const {
    const int last = size_ - 1;  // of a power of two
    return static_cast<double>(values_[static_cast<std::size_t>((y & last) * size_ + (x & last))]);
  }
  int size_;
  std::vector<float> values_;
};

/// Walls between bubbles, normal with variance 1.
Pattern bubbles(int size) {
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
  // The rank of a value, as a share, is the normal distribution's at what is stored for it.
  std::vector<float> values(count);
  double value = -kMostDeviations;
  for (std::size_t rank = 0; rank < count; ++rank) {
    const double share = (static_cast<double>(rank) + 0.5) / static_cast<double>(count);
    while (value < kMostDeviations && 0.5 * std::erfc(-value / std::sqrt(2.0)) < share) {
      value += 0.002;
    }
    values[order[rank]] = static_cast<float>(value);
  }
  return {size, std::move(values)};
}

// Halves: a CPU renderer filters bytes more slowly, and floats fill its cache.
gl::Texture texture_of(const char* label, GLenum format, GLenum channels, int size,
                       const std::vector<float>& values) {
  gl::Texture texture(
      label,
      {.format = format, .width = size, .height = size, .levels = gl::full_mip_levels(size, size)});
  texture.upload(channels, GL_FLOAT, values.data());
  texture.generate_mipmaps();
  return texture;
}

/// `values` of every texel's middle, in units of the foam's grid, of a picture that covers
/// `period`.
template <typename Values>
std::vector<float> painted(int size, double period, const Values& values) {
  std::vector<float> pixels;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      for (const double value : values(period * (x + 0.5) / size, period * (y + 0.5) / size)) {
        pixels.push_back(static_cast<float>(value));
      }
    }
  }
  return pixels;
}

}  // namespace

FoamPatterns make_foam_patterns() {
  constexpr int kBubbleTexels = 256;
  const Pattern pattern = bubbles(kBubbleTexels);
  // Deviations of lace and bubbles, of torn patches, and of lines along the wind that join and
  // part, in rows. Factors are whole numbers over the period.
  const auto fine = [&](double x, double y) {
    return std::array{kFoamLace * pattern(1.5 * x, y) + kFoamBubbles * pattern(3.0 * y, 4.5 * x)};
  };
  const auto wide = [&](double x, double y) {
    return std::array{pattern(0.375 * x, 0.25 * y),
                      kStreakRows * pattern(0.125 * x, 0.125 * y) +
                          kStreakLines * pattern(0.125 * x, 0.625 * y + 0.125 * x) +
                          kStreakThreads * pattern(0.25 * x, 1.75 * y - 0.125 * x)};
  };
  return {texture_of("sea.foam", GL_R16F, GL_RED, kBubbleTexels, pattern.values()),
          texture_of("sea.foam_lace", GL_R16F, GL_RED, kFoamTexels,
                     painted(kFoamTexels, kFoamLacePeriod, fine)),
          texture_of("sea.foam_rows", GL_RG16F, GL_RG, kFoamTexels,
                     painted(kFoamTexels, kFoamRowsPeriod, wide))};
}

}  // namespace offing
