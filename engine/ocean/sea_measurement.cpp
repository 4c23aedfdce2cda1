#include "engine/ocean/sea_measurement.h"

#include <fftw3.h>

#include <cmath>
#include <complex>
#include <map>
#include <vector>

#include "engine/core/angles.h"

namespace offing {
namespace {

// Forward transform in place, divided by the number of points: Parseval then gives the variance.
void transform(std::vector<std::complex<double>>& values, int size) {
  auto* data = reinterpret_cast<fftw_complex*>(values.data());
  const fftw_plan plan = fftw_plan_dft_2d(size, size, data, data, FFTW_FORWARD, FFTW_ESTIMATE);
  fftw_execute(plan);
  fftw_destroy_plan(plan);
  for (std::complex<double>& value : values) value /= static_cast<double>(size) * size;
}

}  // namespace

SeaMeasurement measure_sea(std::span<const Cascade> cascades, std::span<const float> displacement) {
  constexpr double kBin = 0.04;  // rad/s: wider than the spacing of a long cascade's waves
  SeaMeasurement sea;
  std::map<int, double> energy;  // by bin of frequency, m^2
  std::size_t first = 0;
  for (const Cascade& cascade : cascades) {
    const auto points =
        static_cast<std::size_t>(cascade.size) * static_cast<std::size_t>(cascade.size);
    std::vector<std::complex<double>> heights(points);
    for (std::size_t i = 0; i < points; ++i) {
      heights[i] = static_cast<double>(displacement[(first + i) * 4 + 1]);
    }
    first += points;
    transform(heights, cascade.size);
    for (std::size_t i = 1; i < points; ++i) {  // 0 is the mean
      const double share = std::norm(heights[i]);
      sea.m0 += share;
      energy[static_cast<int>(cascade.frequency[i] / kBin)] += share;
    }
  }
  sea.hs = 4.0 * std::sqrt(sea.m0);
  double weight = 0.0, moment = 0.0;
  for (const auto& [bin, share] : energy) {
    const double fourth = std::pow(share / std::max(sea.m0, 1e-300), 4.0);
    weight += fourth;
    moment += fourth * (bin + 0.5) * kBin;
  }
  if (moment > 0.0) sea.tp = kTau * weight / moment;
  return sea;
}

}  // namespace offing
