#include "engine/ocean/roughness_table.h"

#include <algorithm>
#include <cmath>

#include "engine/core/angles.h"
#include "shaders/shared/ocean.h"

namespace offing {
namespace {

/// Of sea_map_share() in shaders/ocean/surface.glsl.
constexpr double kFadeFirst = 4.0, kFadeLast = 5.5;

double share_shown(double level) {
  const double t = std::clamp((level - kFadeFirst) / (kFadeLast - kFadeFirst), 0.0, 1.0);
  return 1.0 - t * t * (3.0 - 2.0 * t);
}

/// Amplitudes (rms over where one looks between the points) that a map level keeps of waves with n
/// = 0 … size/4 - 1 periods per patch: the mean of 2^level points, then straight lines.
std::vector<double> kept_amplitudes(int size, int level) {
  std::vector<double> kept;
  const double width = std::exp2(level);
  for (int n = 0; n < size / 4; ++n) {
    const double half = kPi * n / size;
    const double mean = n == 0 ? 1.0 : std::sin(width * half) / (width * std::sin(half));
    kept.push_back(std::abs(mean) * std::sqrt((2.0 + std::cos(2.0 * width * half)) / 3.0));
  }
  return kept;
}

double point_log2(const Cascade& cascade) { return std::log2(cascade.band.length / cascade.size); }

SlopeVariance shown_of(const Cascade& cascade, double level) {
  const double share = share_shown(level);
  if (share <= 0.0) return {};
  const int fine = std::min(static_cast<int>(level), shared::kOceanMapLevels - 2);
  const double part = std::min(level - fine, 1.0);
  const auto a = kept_amplitudes(cascade.size, fine), b = kept_amplitudes(cascade.size, fine + 1);
  SlopeVariance sum;
  for (std::size_t z = 0; z < a.size(); ++z) {
    for (std::size_t x = 0; x < a.size(); ++x) {
      const double amplitude = share * ((1.0 - part) * a[x] * a[z] + part * b[x] * b[z]);
      const SlopeVariance& cell = cascade.slope_cells[z * a.size() + x];
      const double weight = amplitude * amplitude;
      sum += {weight * cell.xx, weight * cell.zz, weight * cell.xz};
    }
  }
  return sum;
}

}  // namespace

double ripple_share(std::span<const Cascade> cascades, const SlopeVariance& total) {
  constexpr double kMost = 0.7;  // of what is left: the rest is finer still
  double left = total.total();
  for (const Cascade& cascade : cascades) left -= cascade.resolved[0].total();
  const double finest = cascades.back().resolved[0].total();
  return finest > 0.0 ? std::clamp(kMost * left / finest, 0.0, 1.0) : 0.0;
}

int breaking_cascades(std::span<const Cascade> cascades) {
  constexpr double kLongestRipple = 5.0;  // m
  return static_cast<int>(std::ranges::count_if(
      cascades, [](const Cascade& cascade) { return cascade.band.k_min < kTau / kLongestRipple; }));
}

std::vector<glm::vec4> roughness_table(std::span<const Cascade> cascades,
                                       const SlopeVariance& total, double ripples) {
  constexpr double kLeast = 4.0e-4;  // of a glassy sea: keeps densities finite
  const auto breaking = static_cast<std::size_t>(breaking_cascades(cascades));
  double breaking_trace = 0.0;
  for (const Cascade& cascade : cascades.first(breaking)) {
    breaking_trace += cascade.resolved[0].total();
  }
  std::vector<glm::vec4> table;
  for (int i = 0; i < shared::kRoughnessEntries; ++i) {
    const double size_log2 = static_cast<double>(shared::kRoughnessFirst) +
                             i / static_cast<double>(shared::kRoughnessSteps);
    SlopeVariance rest = total;
    double trace = breaking_trace;
    for (std::size_t c = 0; c < cascades.size(); ++c) {
      const SlopeVariance shown =
          shown_of(cascades[c], std::max(size_log2 - point_log2(cascades[c]), 0.0));
      rest += {-shown.xx, -shown.zz, -shown.xz};
      if (c < breaking) trace -= shown.total();
    }
    if (ripples > 0.0) {
      const double size_in_map = size_log2 - std::log2(static_cast<double>(shared::kRippleScale));
      const SlopeVariance shown =
          shown_of(cascades.back(), std::max(size_in_map - point_log2(cascades.back()), 0.0));
      rest += {-ripples * shown.xx, -ripples * shown.zz, -ripples * shown.xz};
    }
    rest.xx = std::max(rest.xx, kLeast);
    rest.zz = std::max(rest.zz, kLeast);
    const double bound = 0.9 * std::sqrt(rest.xx * rest.zz);
    rest.xz = std::clamp(rest.xz, -bound, bound);
    table.emplace_back(
        glm::dvec4(rest.xx, rest.zz, rest.xz,
                   breaking_trace > 0.0 ? std::max(trace / breaking_trace, 0.0) : 1.0));
  }
  return table;
}

}  // namespace offing
