#include "engine/ocean/spectrum.h"

#include <algorithm>
#include <cmath>

#include "engine/core/angles.h"
#include "engine/core/random.h"

#define OFFING_GLSL "shaders/lib/waves.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

constexpr double kCos2sExponent = 6.0;  // mean of a wind sea: 10 near the peak, less in the tail
constexpr double kCalmWind = 0.1;       // m/s: less raises no waves
constexpr int kSamplesPerWave = 4;

glm::dvec2 direction_to(double from_deg) {
  const double azimuth = radians(from_deg);
  return {-std::sin(azimuth), std::cos(azimuth)};
}

double angle_between(glm::dvec2 k, glm::dvec2 direction) {
  return std::atan2(direction.x * k.y - direction.y * k.x, glm::dot(k, direction));
}

// Table of the norms of elongated_shape(): octaves of frequency on both sides of the peak.
constexpr double kNormReach = 6.0;
constexpr double kNormsPerOctave = 32.0;

double elongated_shape(double angle, double beta, double exponent) {
  return glsl::spread_donelan_banner(angle, beta) *
         std::pow(std::max(std::abs(std::cos(0.5 * angle)), 1e-30), 2.0 * exponent);
}

/// The index of a grid place as a signed wave number.
int signed_index(int i, int size) { return i < size / 2 ? i : i - size; }

/// A patch holds few of the longest waves, and chance would make it 10 % too high or too low. The
/// draw is levelled to the height and the slope that it stands for, its variances times a + b k^2:
/// groups stay random, Hs is right and so is what the waves leave to the roughness. `drawn`: its
/// moments of k^0, k^2 and k^4, `slope` the expected one of k^2.
void level_draw(Cascade& cascade, double slope, const double (&drawn)[3]) {
  if (!(drawn[0] > 0.0)) return;
  double a = cascade.variance / drawn[0], b = 0.0;
  const double det = drawn[0] * drawn[2] - drawn[1] * drawn[1];
  if (det > 1e-9 * drawn[0] * drawn[2]) {  // else all of one length
    const double both = (cascade.variance * drawn[2] - slope * drawn[1]) / det;
    const double steeper = (slope * drawn[0] - cascade.variance * drawn[1]) / det;
    // Few waves can be so far off that no such weights are positive: then the height alone.
    const double most = std::pow(cascade.band.k_max, 2.0),
                 least = std::pow(cascade.band.k_min, 2.0);
    if (std::min(both + steeper * least, both + steeper * most) > 0.25 * a) {
      a = both;
      b = steeper;
    }
  }
  for (int iz = 0; iz < cascade.size; ++iz) {
    for (int ix = 0; ix < cascade.size; ++ix) {
      std::complex<double>& h0 = cascade.h0[static_cast<std::size_t>(iz * cascade.size + ix)];
      if (h0 == 0.0) continue;
      const glm::dvec2 k = cascade.wave_vector(ix, iz);
      h0 *= std::sqrt(a + b * glm::dot(k, k));
    }
  }
}

}  // namespace

SlopeVariance& SlopeVariance::operator+=(const SlopeVariance& other) {
  xx += other.xx;
  zz += other.zz;
  xz += other.xz;
  return *this;
}

SeaSpectrum::SeaSpectrum(const SeaState& state, double wind_speed, glm::dvec2 wind_to)
    : state_(state),
      wind_speed_(wind_speed),
      wind_to_(wind_to),
      swell_to_(direction_to(state.swell.from_deg)) {
  if (wind_speed_ > kCalmWind) {
    if (state_.spectrum == kPiersonMoskowitz) {
      wind_peak_ = glsl::pierson_moskowitz_peak(wind_speed_);
    } else {
      const double chi = glsl::dimensionless_fetch(wind_speed_, 1000.0 * state_.fetch_km);
      wind_peak_ = glsl::jonswap_peak(wind_speed_, chi);
      alpha_ = glsl::jonswap_alpha(chi);
    }
  }
  if (state_.swell.height > 0.0) swell_peak_ = kTau / state_.swell.period;
  for (const double peak : {wind_peak_, swell_peak_}) {
    if (peak > 0.0) {
      longest_peak_ = std::max(longest_peak_, kTau / glsl::wave_number(peak, state_.depth_m));
    }
  }
  if (wind_peak_ > 0.0 && state_.spreading == kDonelanBanner && state_.elongation > 0.0) {
    // The trapezium rule round a full circle; the cusp opposite the wind leaves some 1e-5.
    constexpr int kAngles = 1024;
    for (int i = 0; i <= static_cast<int>(2.0 * kNormReach * kNormsPerOctave); ++i) {
      const double w = wind_peak_ * std::exp2(i / kNormsPerOctave - kNormReach);
      double sum = 0.0;
      for (int a = 0; a < kAngles; ++a) {
        sum += elongated_shape(kTau * a / kAngles - kPi, glsl::donelan_banner_beta(w, wind_peak_),
                               glsl::swell_elongation_exponent(w, wind_peak_, state_.elongation));
      }
      elongated_norms_.push_back(kAngles / (kTau * sum));
    }
  }
  statistics_ = integrate();
}

double SeaSpectrum::wind_sea(double w, double k) const {
  if (wind_peak_ == 0.0) return 0.0;
  switch (state_.spectrum) {
    case kPiersonMoskowitz:
      return glsl::pierson_moskowitz(w, wind_speed_);
    case kJonswap:
      return glsl::jonswap_shape(w, wind_peak_, alpha_, glsl::kJonswapGamma);
    case kTma:
      return glsl::jonswap_shape(w, wind_peak_, alpha_, glsl::kJonswapGamma) *
             glsl::kitaigorodskii(k * state_.depth_m);
  }
  return 0.0;
}

double SeaSpectrum::wind_spreading(double w, double angle) const {
  const double longer = glsl::swell_elongation_exponent(w, wind_peak_, state_.elongation);
  switch (state_.spreading) {
    case kCos2s:
      return glsl::spread_cos2s(angle, kCos2sExponent + longer);
    case kMitsuyasu:
      return glsl::spread_cos2s(angle,
                                glsl::mitsuyasu_exponent(w, wind_peak_, wind_speed_) + longer);
    case kHasselmann:
      return glsl::spread_cos2s(angle,
                                glsl::hasselmann_exponent(w, wind_peak_, wind_speed_) + longer);
    case kDonelanBanner:
      if (state_.elongation > 0.0) return elongated_donelan_banner(w, angle);
      return glsl::spread_donelan_banner(angle, glsl::donelan_banner_beta(w, wind_peak_));
  }
  return 0.0;
}

double SeaSpectrum::elongated_donelan_banner(double w, double angle) const {
  // The product of both shapes has no integral in closed form: tabulated over log2(w / peak).
  const double at = (std::clamp(std::log2(w / wind_peak_), -kNormReach, kNormReach) + kNormReach) *
                    kNormsPerOctave;
  const auto first = std::min(static_cast<std::size_t>(at), elongated_norms_.size() - 2);
  const double part = at - static_cast<double>(first);
  const double norm =
      elongated_norms_[first] + part * (elongated_norms_[first + 1] - elongated_norms_[first]);
  return norm * elongated_shape(angle, glsl::donelan_banner_beta(w, wind_peak_),
                                glsl::swell_elongation_exponent(w, wind_peak_, state_.elongation));
}

double SeaSpectrum::frequency(double k) const { return glsl::wave_frequency(k, state_.depth_m); }

double SeaSpectrum::frequency_density(double w) const {
  double density = wind_sea(w, glsl::wave_number(w, state_.depth_m));
  if (swell_peak_ > 0.0) density += glsl::swell_spectrum(w, state_.swell.height, swell_peak_);
  return density;
}

double SeaSpectrum::density(glm::dvec2 wave_vector) const {
  const double k = glm::length(wave_vector);
  if (k <= 0.0) return 0.0;
  const double w = frequency(k);
  double directional = 0.0;
  if (const double wind = wind_sea(w, k); wind > 0.0) {
    directional = wind * wind_spreading(w, angle_between(wave_vector, wind_to_));
  }
  if (swell_peak_ > 0.0) {
    directional +=
        glsl::swell_spectrum(w, state_.swell.height, swell_peak_) *
        glsl::spread_cos2s(angle_between(wave_vector, swell_to_), state_.swell.spreading);
  }
  return directional * glsl::wave_group_speed(k, state_.depth_m) / k;
}

SeaStatistics SeaSpectrum::integrate() const {
  // Simpson's rule on a logarithmic grid of wave numbers, from 60 km waves to where capillarity
  // has ended the slope integral. The kink of the peak's width costs less than 1e-5.
  constexpr int kSteps = 8192;
  constexpr double kFirst = 1.0e-4, kLast = 1.0e4;
  const double step = std::log(kLast / kFirst) / kSteps;
  SeaStatistics sum;
  double best = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const double k = kFirst * std::exp(step * i);
    const double w = frequency(k);
    double s = wind_sea(w, k);
    if (swell_peak_ > 0.0) s += glsl::swell_spectrum(w, state_.swell.height, swell_peak_);
    if (s > best) {
      best = s;
      sum.tp = kTau / w;
    }
    const double weight = (i == 0 || i == kSteps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * step / 3.0;
    const double variance = weight * s * glsl::wave_group_speed(k, state_.depth_m) * k;
    sum.m0 += variance;
    sum.mean_square_slope += variance * k * k;
  }
  sum.hs = 4.0 * std::sqrt(sum.m0);
  return sum;
}

std::vector<CascadeBand> choose_bands(const SeaSpectrum& spectrum, int count, int size) {
  // The first patch holds a few of the longest waves, the third brings ripples to the viewer's
  // feet; the second lies between in equal ratios. More of them go on to finer ripples. The first
  // is rounded to steps of sqrt(2), so that small changes of the wind leave all lengths alone. Odd
  // factors keep the periods incommensurate.
  constexpr double kThird = 10.37, kFiner = 0.2931;
  const double wanted = std::clamp(5.0 * spectrum.longest_peak(), 256.0, 3000.0);
  const double first = 1.0193 * std::exp2(std::ceil(2.0 * std::log2(wanted)) / 2.0);
  // Half a wave number less than four points per wave: then all cells with energy have indices
  // below size / 4, which is what the transform relies on.
  const double most = static_cast<double>(size) / kSamplesPerWave - 0.5;
  std::vector<CascadeBand> bands(static_cast<std::size_t>(count));
  for (int c = 0; c < count; ++c) {
    CascadeBand& band = bands[static_cast<std::size_t>(c)];
    band.length = c <= 2 ? first * std::pow(kThird / first, 0.5 * c)
                         : kThird * std::pow(kFiner, static_cast<double>(c - 2));
    band.angle = 0.6180339887 * c;
    band.k_min = c == 0 ? 0.0 : bands[static_cast<std::size_t>(c - 1)].k_max;
    band.k_max = kTau / band.length * (c < count - 1 ? std::min(most, kSharedPeriods) : most);
  }
  return bands;
}

glm::dvec2 Cascade::wave_vector(int ix, int iz) const {
  const double dk = kTau / band.length;
  const double x = dk * signed_index(ix, size), z = dk * signed_index(iz, size);
  const double c = std::cos(band.angle), s = std::sin(band.angle);
  return {c * x - s * z, s * x + c * z};
}

Cascade make_cascade(const SeaSpectrum& spectrum, const CascadeBand& band, int size,
                     std::uint64_t seed, int number) {
  Cascade cascade;
  cascade.band = band;
  cascade.size = size;
  const auto cells = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  cascade.h0.assign(cells, 0.0);
  cascade.frequency.assign(cells, 0.0);
  const int quarter = size / kSamplesPerWave;
  cascade.slope_cells.assign(cells / (kSamplesPerWave * kSamplesPerWave), {});
  const double dk = kTau / band.length;
  const double cosine = std::cos(band.angle), sine = std::sin(band.angle);

  // What the mean of 2^level neighbours keeps of a wave with n periods per patch, by |n|.
  std::vector<double> kept(static_cast<std::size_t>(kVarianceLevels * size));
  for (int level = 0; level < kVarianceLevels; ++level) {
    const double width = std::exp2(level);
    for (int n = 0; n < size / 2; ++n) {
      const double half = kPi * n / size;
      const double mean = n == 0 ? 1.0 : std::sin(width * half) / (width * std::sin(half));
      kept[static_cast<std::size_t>(level * size + n)] = mean * mean;
    }
  }

  double slope = 0.0;           // expected, summed over both axes
  double drawn[3] = {0, 0, 0};  // moments of what is drawn: |h|^2, |k h|^2, |k^2 h|^2
  for (int iz = 0; iz < size; ++iz) {
    for (int ix = 0; ix < size; ++ix) {
      const int nx = signed_index(ix, size), nz = signed_index(iz, size);
      if (nx == -size / 2 || nz == -size / 2 || (nx == 0 && nz == 0)) continue;
      const double radius = std::hypot(nx, nz);
      const double centre = dk * radius;
      // Cells are integrated finely where the spectrum is steep across them (few periods per
      // patch) and where a band's edge cuts them, so that no energy is lost or counted twice.
      const double reach = 0.7072 * dk;
      if (centre + reach < band.k_min || centre - reach >= band.k_max) continue;
      const bool cut = centre - reach < band.k_min || centre + reach > band.k_max;
      const int samples = radius < 6.0 ? 12 : radius < 16.0 ? 5 : cut ? 4 : 1;
      double energy = 0.0;
      for (int j = 0; j < samples; ++j) {
        for (int i = 0; i < samples; ++i) {
          const double x = dk * (nx + (i + 0.5) / samples - 0.5);
          const double z = dk * (nz + (j + 0.5) / samples - 0.5);
          const double k = std::hypot(x, z);
          if (k < band.k_min || k >= band.k_max) continue;
          energy += spectrum.density({cosine * x - sine * z, sine * x + cosine * z});
        }
      }
      energy *= dk * dk / (samples * samples);

      const std::size_t cell = static_cast<std::size_t>(iz * size + ix);
      const glm::dvec2 k = cascade.wave_vector(ix, iz);
      cascade.frequency[cell] = spectrum.frequency(glm::length(k));
      const auto index =
          static_cast<std::uint64_t>(nx + 32768) * 65536u + static_cast<std::uint64_t>(nz + 32768);
      const glm::dvec2 normal = random_normal_pair(seed, static_cast<std::uint64_t>(number), index);
      cascade.h0[cell] = 0.5 * std::sqrt(energy) * std::complex<double>(normal.x, normal.y);
      cascade.variance += energy;
      const double k2 = glm::dot(k, k), variance = 2.0 * std::norm(cascade.h0[cell]);
      slope += energy * k2;
      drawn[0] += variance;
      drawn[1] += variance * k2;
      drawn[2] += variance * k2 * k2;
      if (std::abs(nx) < quarter && std::abs(nz) < quarter) {
        cascade.slope_cells[static_cast<std::size_t>(std::abs(nz) * quarter + std::abs(nx))] +=
            {energy * k.x * k.x, energy * k.y * k.y, energy * k.x * k.y};
      }
      cascade.slope_rate += energy * glm::dot(k, k) * std::pow(cascade.frequency[cell], 2);
      for (int level = 0; level < kVarianceLevels; ++level) {
        const double share = energy * kept[static_cast<std::size_t>(level * size + std::abs(nx))] *
                             kept[static_cast<std::size_t>(level * size + std::abs(nz))];
        cascade.resolved[level] += {share * k.x * k.x, share * k.y * k.y, share * k.x * k.y};
      }
    }
  }
  level_draw(cascade, slope, drawn);
  return cascade;
}

SlopeVariance cox_munk(double wind_speed, glm::dvec2 wind_to) {
  const double wind = 1.018 * wind_speed;
  const double up = 0.00316 * wind, cross = 0.003 + 0.00192 * wind;
  const double x = wind_to.x, z = wind_to.y;
  return {up * x * x + cross * z * z, up * z * z + cross * x * x, (up - cross) * x * z};
}

}  // namespace offing
