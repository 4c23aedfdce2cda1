#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/core/random.h"
#include "engine/ocean/fft_moments.h"
#include "engine/ocean/sea_water.h"

namespace offing {
namespace {

constexpr int kSize = 128;

std::vector<Cascade> make_cascades(const SeaSpectrum& spectrum, std::uint64_t seed) {
  std::vector<Cascade> cascades;
  for (const CascadeBand& band : choose_bands(spectrum, 2, kSize)) {
    const int number = static_cast<int>(cascades.size());
    cascades.push_back(make_cascade(spectrum, band, kSize, seed, number));
  }
  return cascades;
}

/// All waves of a sea by their energy.
class Waves {
 public:
  explicit Waves(std::span<const Cascade> cascades) {
    for (const Cascade& cascade : cascades) {
      for (int z = 0; z < kSize; ++z) {
        for (int x = 0; x < kSize; ++x) {
          const double e = 2.0 * std::norm(cascade.h0[static_cast<std::size_t>(z * kSize + x)]);
          if (e == 0.0) continue;
          m0_ += e;
          k_.push_back(cascade.wave_vector(x, z));
          mean_k_ += e * glm::length(k_.back());
          until_.push_back(m0_);
        }
      }
    }
    mean_k_ /= m0_;
  }
  double m0() const { return m0_; }          // m^2
  double mean_k() const { return mean_k_; }  // weighted with energy, rad/m
  /// One of them, as likely as its share of the energy.
  glm::dvec2 draw(double chance) const {
    const auto at = std::lower_bound(until_.begin(), until_.end(), chance * m0_);
    return k_[static_cast<std::size_t>(at - until_.begin())];
  }

 private:
  std::vector<glm::dvec2> k_;
  std::vector<double> until_;
  double m0_ = 0.0, mean_k_ = 0.0;
};

// What is left of a wave when a running mean over exp(-x^2 / 2 L^2) is taken off along a line.
double passed(double k, double width) { return 1.0 - std::exp(-0.5 * k * k * width * width); }

// Third moment of the heights along a line without their running mean.
double third_moment(const std::vector<WaterSample>& line, double width) {
  const int reach = static_cast<int>(std::ceil(4.0 * width));
  std::vector<double> weights;
  for (int i = -reach; i <= reach; ++i) weights.push_back(std::exp(-0.5 * i * i / width / width));
  const double norm = std::accumulate(weights.begin(), weights.end(), 0.0);
  double sum = 0.0;
  int count = 0;
  for (int i = reach; i + reach < static_cast<int>(line.size()); ++i, ++count) {
    double mean = 0.0;
    for (int j = -reach; j <= reach; ++j) {
      mean += weights[static_cast<std::size_t>(j + reach)] *
              line[static_cast<std::size_t>(i + j)].height / norm;
    }
    sum += std::pow(line[static_cast<std::size_t>(i)].height - mean, 3.0);
  }
  return sum / count;
}

struct Skewness {
  double measured = 0.0, expected = 0.0;
};

// Of the waves along their own way, groups left out: a group of free waves lowers the water by as
// much as its crests gain, which takes all skewness of the whole away (a bound long wave would
// raise it again). Expected from pairs of waves at second order: eta_2 = -D . grad h.
Skewness skewness(const SeaState& state, double wind, glm::dvec2 along, double choppiness) {
  constexpr int kSeeds = 12, kLines = 6, kPoints = 3000, kPairs = 20000;
  const SeaSpectrum spectrum(state, wind, along);
  Skewness skewness;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const auto cascades = make_cascades(spectrum, seed);
    const Waves waves(cascades);
    const double width = 2.2 / waves.mean_k(), step = 0.4 / waves.mean_k();
    const double sigma3 = std::pow(waves.m0(), 1.5);
    // The same sea without choppiness has the same chance asymmetry.
    for (const double c : {0.0, choppiness}) {
      SeaWater water(std::make_unique<FftMoments>());
      water.set_waves(std::make_shared<QueryWaves>(cascades, 2), c, INFINITY);
      for (int number = 0; number < kLines; ++number) {
        const glm::dvec2 start = 137.0 * number * glm::dvec2(-along.y, along.x);
        std::vector<glm::dvec2> places;
        for (int i = 0; i < kPoints; ++i) places.push_back(start + along * (step * i));
        std::vector<WaterSample> line(places.size());
        water.sample(places, 100.0, line);
        const double third = third_moment(line, width / step) / sigma3;
        skewness.measured += (c > 0.0 ? third : -third) / (kSeeds * kLines);
      }
    }
    double sum = 0.0;
    for (std::uint64_t i = 0; i < kPairs; ++i) {
      const glm::dvec2 a = waves.draw(random_uniform(seed, 1, i)),
                       b = waves.draw(random_uniform(seed, 2, i));
      const double ka = glm::dot(a, along), kb = glm::dot(b, along);
      sum += glm::dot(glm::normalize(a), b) * passed(ka, width) * passed(kb, width) *
             (passed(ka + kb, width) - passed(ka - kb, width)) *
             (a == b ? 0.5 : 1.0);  // a wave with itself is one pair, not two
    }
    skewness.expected += 3.0 * choppiness * sum / kPairs * std::sqrt(waves.m0()) / kSeeds;
  }
  return skewness;
}

TEST(SeaSkewness, OfASwellIsThatOfSecondOrder) {
  SeaState state;
  state.swell = {.height = 3.0, .period = 9.0, .from_deg = 180.0, .spreading = 500.0};
  for (const double choppiness : {0.5, 1.0}) {
    const Skewness got = skewness(state, 0.0, {0.0, 1.0}, choppiness);
    EXPECT_NEAR(got.measured / got.expected, 1.0, 0.12) << choppiness;
  }
}

TEST(SeaSkewness, GrowsWithChoppiness) {
  SeaState state;
  state.swell.height = 0.0;
  Skewness got[2];
  for (const int i : {0, 1}) got[i] = skewness(state, 10.0, {0.6, 0.8}, 0.5 + 0.5 * i);
  EXPECT_GT(got[0].measured, 0.0);
  EXPECT_GT(got[1].measured, 1.5 * got[0].measured);
  EXPECT_NEAR(got[0].measured / got[0].expected, 1.0, 0.15);
}

}  // namespace
}  // namespace offing
