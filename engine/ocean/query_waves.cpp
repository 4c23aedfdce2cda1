#include "engine/ocean/query_waves.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "engine/core/angles.h"

namespace offing {
namespace {

// The spectrum of the cubic B-spline at `angle` (rad per point).
double spline_spectrum(double angle) {
  const double half = 0.5 * angle;
  const double sinc = std::abs(half) < 1e-9 ? 1.0 : std::sin(half) / half;
  return sinc * sinc * sinc * sinc;
}

// The coefficient per amplitude with which splines come closest to a wave (least squares over its
// course): its spectrum at the wave over the energy of all its images (Unser 1999, eq. 33).
double spline_gain(int periods, int size) {
  const double angle = kTau * periods / size;
  double energy = 0.0;
  for (int image = -6; image <= 6; ++image) {
    const double part = spline_spectrum(angle + kTau * image);
    energy += part * part;
  }
  return spline_spectrum(angle) / energy;
}

int signed_index(int i, int size) { return i < size / 2 ? i : i - size; }

}  // namespace

QueryWaves::QueryWaves(std::span<const Cascade> cascades, int count) {
  for (int c = 0; c < count; ++c) {
    const CascadeBand& band = cascades[static_cast<std::size_t>(c)].band;
    const auto periods = static_cast<unsigned>(band.k_max * band.length / kTau + 0.6);
    size_ = std::max({size_, 64, static_cast<int>(std::bit_ceil(4 * periods))});
  }
  std::vector<double> gain;
  gain.reserve(static_cast<std::size_t>(size_));
  for (int i = 0; i < size_; ++i) gain.push_back(spline_gain(signed_index(i, size_), size_));
  for (int c = 0; c < count; ++c) {
    const Cascade& from = cascades[static_cast<std::size_t>(c)];
    Cascade to;
    to.band = from.band;
    to.size = size_;
    to.variance = from.variance;
    const auto cells = static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_);
    to.h0.assign(cells, 0.0);
    to.frequency.assign(cells, 0.0);
    const int reach = std::min(from.size, size_) / 2;
    for (int nz = 1 - reach; nz < reach; ++nz) {
      for (int nx = 1 - reach; nx < reach; ++nx) {
        const int x = (nx + from.size) % from.size, z = (nz + from.size) % from.size;
        const int tx = (nx + size_) % size_, tz = (nz + size_) % size_;
        const auto source = static_cast<std::size_t>(z * from.size + x);
        const auto target = static_cast<std::size_t>(tz * size_ + tx);
        to.h0[target] = from.h0[source] * gain[static_cast<std::size_t>(tx)] *
                        gain[static_cast<std::size_t>(tz)];
        to.frequency[target] = from.frequency[source];
      }
    }
    cascades_.push_back(std::move(to));
  }
}

}  // namespace offing
