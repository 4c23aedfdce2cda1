#include "engine/environment/gust_field.h"

#include <fftw3.h>

#include <cmath>
#include <complex>
#include <memory>

#include "engine/core/angles.h"
#include "engine/core/random.h"

namespace offing {
namespace {

constexpr std::uint64_t kSeed = 20260812;
constexpr double kLength = 150.0;  // metres: the energetic eddies at 10 m over the sea
constexpr double kSmooth =
    8.0;  // metres: standard deviation that keeps a 3 s gust and drops faster

/// Density over the plane whose cut along any line falls as (1 + (k L)^2)^(-5/6), von Kármán's
/// longitudinal spectrum: (1 + (k L)^2)^(-4/3).
double density(double k) {
  const double kl = k * kLength;
  return std::pow(1.0 + kl * kl, -4.0 / 3.0) * std::exp(-k * k * kSmooth * kSmooth);
}

}  // namespace

GustField::GustField() : grid_(static_cast<std::size_t>(kSize) * kSize) {
  constexpr int kHalf = kSize / 2 + 1;
  const auto count = static_cast<std::size_t>(kSize) * kHalf;
  std::unique_ptr<fftwf_complex, decltype(&fftwf_free)> waves(fftwf_alloc_complex(count),
                                                              fftwf_free);
  fftwf_plan plan = fftwf_plan_dft_c2r_2d(kSize, kSize, waves.get(), grid_.data(), FFTW_ESTIMATE);
  for (int row = 0; row < kSize; ++row) {
    const int nz = row <= kSize / 2 ? row : row - kSize;
    for (int nx = 0; nx < kHalf; ++nx) {
      const auto index = static_cast<std::size_t>(row) * kHalf + static_cast<std::size_t>(nx);
      const double k = kTau / kPeriod * std::hypot(nx, nz);
      const bool mean = nx == 0 && nz == 0;
      const double amplitude = mean ? 0.0 : std::sqrt(density(k));
      const glm::dvec2 noise = random_normal_pair(kSeed, 0, index);
      waves.get()[index][0] = static_cast<float>(amplitude * noise.x);
      waves.get()[index][1] = static_cast<float>(amplitude * noise.y);
    }
  }
  fftwf_execute(plan);
  fftwf_destroy_plan(plan);

  double sum = 0.0, sum2 = 0.0;
  for (float value : grid_) {
    sum += value;
    sum2 += static_cast<double>(value) * value;
  }
  const double mean = sum / static_cast<double>(grid_.size());
  const double scale = 1.0 / std::sqrt(sum2 / static_cast<double>(grid_.size()) - mean * mean);
  for (float& value : grid_) value = static_cast<float>((value - mean) * scale);
}

double GustField::at(glm::dvec2 position) const {
  const double x = position.x / kCell - 0.5, z = position.y / kCell - 0.5;
  const double fx = std::floor(x), fz = std::floor(z);
  const double u = x - fx, v = z - fz;
  constexpr long long kMask = kSize - 1;
  static_assert((kSize & kMask) == 0);
  const auto i0 = static_cast<std::size_t>(static_cast<long long>(fx) & kMask);
  const auto j0 = static_cast<std::size_t>(static_cast<long long>(fz) & kMask);
  const std::size_t i1 = (i0 + 1) & kMask, j1 = (j0 + 1) & kMask;
  const float* row0 = grid_.data() + j0 * kSize;
  const float* row1 = grid_.data() + j1 * kSize;
  const double top = row0[i0] + u * (row0[i1] - row0[i0]);
  const double bottom = row1[i0] + u * (row1[i1] - row1[i0]);
  return top + v * (bottom - top);
}

const GustField& gust_field() {
  static const GustField field;
  return field;
}

}  // namespace offing
