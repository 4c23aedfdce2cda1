#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/angles.h"
#include "engine/ocean/direct_water.h"
#include "engine/ocean/sea_mesh.h"
#include "engine/ocean/spectrum.h"

namespace offing {
namespace {

SeaState wind_sea(int spectrum, double fetch_km, int spreading = kHasselmann) {
  SeaState state;
  state.spectrum = spectrum;
  state.spreading = spreading;
  state.fetch_km = fetch_km;
  state.swell.height = 0.0;
  return state;
}

std::vector<Cascade> cascades_of(const SeaSpectrum& spectrum, int count, int size,
                                 std::uint64_t seed) {
  std::vector<Cascade> cascades;
  for (const CascadeBand& band : choose_bands(spectrum, count, size)) {
    cascades.push_back(make_cascade(spectrum, band, size, seed, static_cast<int>(cascades.size())));
  }
  return cascades;
}

TEST(SeaSpectrum, HeightsAgreeWithIndependentTables) {
  const struct {
    int spectrum;
    double wind, fetch, hs;
  } rows[] = {{kPiersonMoskowitz, 5, 1, 0.5613},  {kPiersonMoskowitz, 10, 1, 2.2453},
              {kPiersonMoskowitz, 15, 1, 5.0520}, {kPiersonMoskowitz, 20, 1, 8.9814},
              {kJonswap, 10, 100, 2.1386},        {kJonswap, 15, 100, 3.0638},
              {kJonswap, 5, 50, 0.7864},          {kJonswap, 20, 500, 9.6857}};
  for (const auto& row : rows) {
    const SeaSpectrum sea(wind_sea(row.spectrum, row.fetch), row.wind, {0, 1});
    EXPECT_NEAR(sea.statistics().hs / row.hs, 1.0, 3e-4) << row.wind;
  }
  EXPECT_NEAR(SeaSpectrum(wind_sea(kPiersonMoskowitz, 1), 10.0, {0, 1}).statistics().tp, 7.492,
              0.01);
}

TEST(SeaSpectrum, GrowthStopsAtTheFullyDevelopedSea) {
  const double far = SeaSpectrum(wind_sea(kJonswap, 2000), 8.0, {0, 1}).statistics().hs;
  const double farther = SeaSpectrum(wind_sea(kJonswap, 1000), 8.0, {0, 1}).statistics().hs;
  const double developed = SeaSpectrum(wind_sea(kPiersonMoskowitz, 1), 8.0, {0, 1}).statistics().hs;
  EXPECT_DOUBLE_EQ(far, farther);
  // The law for the height is a fit of its own; the spectrum's integral, which goes with chi^.557,
  // stands 1.42 times above it there.
  EXPECT_NEAR(far / developed, 1.416, 0.02);
}

TEST(SeaSpectrum, WindSeaAndSwellAddTheirVariances) {
  SeaState state = wind_sea(kJonswap, 100);
  const double wind_only = SeaSpectrum(state, 10.0, {0, 1}).statistics().m0;
  state.swell = {.height = 3.0, .period = 14.0, .from_deg = 250.0};
  const double both = SeaSpectrum(state, 10.0, {0, 1}).statistics().m0;
  EXPECT_NEAR(both, wind_only + 9.0 / 16.0, 1e-3);
}

TEST(Cascades, BandsMeetWithoutOverlapOrGapAndResolveTheirWaves) {
  for (const double wind : {0.0, 4.0, 12.0, 30.0, 60.0}) {
    const SeaSpectrum sea(wind_sea(kJonswap, 500), wind, {0, 1});
    for (const int size : {64, 128, 512}) {
      const auto bands = choose_bands(sea, 5, size);
      EXPECT_EQ(bands.front().k_min, 0.0);
      for (std::size_t c = 0; c < bands.size(); ++c) {
        if (c > 0) {
          EXPECT_EQ(bands[c].k_min, bands[c - 1].k_max);
        }
        EXPECT_LT(bands[c].k_min, bands[c].k_max);
        const double shortest = kTau / bands[c].k_max;
        EXPECT_GE(shortest / (bands[c].length / size), 4.0);
      }
    }
  }
}

TEST(Cascades, ExpectedVarianceIsTheSpectrumsIntegralOverTheBands) {
  for (const int spectrum : {kPiersonMoskowitz, kJonswap, kTma}) {
    for (const int spreading : {kCos2s, kMitsuyasu, kHasselmann, kDonelanBanner}) {
      for (const double wind : {6.0, 12.0, 22.0}) {
        SeaState state = wind_sea(spectrum, 150, spreading);
        state.depth_m = spectrum == kTma ? 20.0 : 1000.0;
        const SeaSpectrum sea(state, wind, {0.6, -0.8});
        const auto cascades = cascades_of(sea, 3, 64, 1);
        double carried = 0.0;
        for (const auto& cascade : cascades) carried += cascade.variance;
        // What lies beyond the last band: integral over k of S dw/dk, by the midpoint rule.
        double beyond = 0.0;
        const double first = cascades.back().band.k_max;
        for (double k = first; k < 300.0; k *= 1.01) {
          const double a = sea.frequency(k), b = sea.frequency(1.01 * k);
          beyond += sea.frequency_density(0.5 * (a + b)) * (b - a);
        }
        EXPECT_NEAR((carried + beyond) / sea.statistics().m0, 1.0, 0.01)
            << spectrum << " " << spreading << " " << wind;
      }
    }
  }
}

// Sum of |h0|^2 over a seed's waves estimates m0 (its mean over a patch and over time).
TEST(Cascades, HeightOfAnEnsembleOfSeedsIsTheSpectrums) {
  const SeaSpectrum sea(wind_sea(kJonswap, 100), 10.0, {0, 1});
  double sum = 0.0;
  constexpr int kSeeds = 24;
  for (int seed = 0; seed < kSeeds; ++seed) {
    for (const auto& cascade : cascades_of(sea, 3, 64, static_cast<std::uint64_t>(seed))) {
      for (const auto& h0 : cascade.h0) sum += 2.0 * std::norm(h0);
    }
  }
  const double hs = 4.0 * std::sqrt(sum / kSeeds);
  EXPECT_NEAR(hs / 2.1386, 1.0, 0.02);
}

TEST(Cascades, AFinerGridKeepsTheLongWaves) {
  const SeaSpectrum sea(wind_sea(kJonswap, 100), 10.0, {0, 1});
  const auto coarse = cascades_of(sea, 3, 64, 5), fine = cascades_of(sea, 3, 128, 5);
  for (int z = -12; z <= 12; ++z) {
    for (int x = -8; x <= 8; ++x) {
      const auto at = [&](int size) {
        return static_cast<std::size_t>(((z + size) % size) * size + (x + size) % size);
      };
      EXPECT_EQ(coarse[0].h0[at(64)], fine[0].h0[at(128)]);
    }
  }
}

TEST(Cascades, EveryLimitGivesAFiniteSea) {
  for (const double wind : {0.0, 0.2, 60.0}) {
    for (const double fetch : {1.0, 2000.0}) {
      for (const double depth : {0.5, 1e4}) {
        for (const int spectrum : {kPiersonMoskowitz, kJonswap, kTma}) {
          for (const int spreading : {kCos2s, kMitsuyasu, kHasselmann, kDonelanBanner}) {
            SeaState state = wind_sea(spectrum, fetch, spreading);
            state.depth_m = depth;
            state.swell = {.height = 15.0, .period = wind > 1.0 ? 25.0 : 3.0, .from_deg = 0.0};
            const SeaSpectrum sea(state, wind, {0, 1});
            EXPECT_TRUE(std::isfinite(sea.statistics().m0 + sea.statistics().mean_square_slope));
            for (const auto& cascade : cascades_of(sea, 1, 64, 1)) {
              double sum = cascade.variance + cascade.resolved[0].total();
              for (const auto& h0 : cascade.h0) sum += std::abs(h0);
              ASSERT_TRUE(std::isfinite(sum))
                  << wind << " " << fetch << " " << depth << " " << spectrum << " " << spreading;
            }
          }
        }
      }
    }
  }
}

TEST(Cascades, NoWindAndNoSwellIsAMirror) {
  const SeaSpectrum sea(wind_sea(kJonswap, 100), 0.0, {0, 1});
  EXPECT_EQ(sea.statistics().hs, 0.0);
  for (const auto& cascade : cascades_of(sea, 3, 64, 1)) EXPECT_EQ(cascade.variance, 0.0);
}

class DirectSea : public ::testing::Test {
 protected:
  DirectSea()
      : cascades_(cascades_of(SeaSpectrum(wind_sea(kJonswap, 100), 10.0, {0.6, 0.8}), 3, 64, 3)),
        water_(cascades_, 0.9) {}
  std::vector<Cascade> cascades_;
  DirectWater water_;
};

TEST_F(DirectSea, DerivativesAgreeWithDifferences) {
  constexpr double kStep = 1e-4, kTime = 321.0;
  for (int i = 0; i < 10; ++i) {
    const glm::dvec2 q(31.7 * i, -17.3 * i);
    const std::vector<glm::dvec2> around = {q, q + glm::dvec2(kStep, 0), q - glm::dvec2(kStep, 0),
                                            q + glm::dvec2(0, kStep), q - glm::dvec2(0, kStep)};
    const auto p = water_.at_parameter(around, kTime);
    const glm::dvec3 dx = (p[1].displacement - p[2].displacement) / (2.0 * kStep);
    const glm::dvec3 dz = (p[3].displacement - p[4].displacement) / (2.0 * kStep);
    EXPECT_NEAR(p[0].slope.x, dx.y, 1e-6);
    EXPECT_NEAR(p[0].slope.y, dz.y, 1e-6);
    EXPECT_NEAR(p[0].dxx, dx.x, 1e-6);
    EXPECT_NEAR(p[0].dzz, dz.z, 1e-6);
    EXPECT_NEAR(p[0].dxz, dz.x, 1e-6);
    EXPECT_NEAR(p[0].dxz, dx.z, 1e-6);
    const auto later = water_.at_parameter(std::span(around).first(1), kTime + kStep);
    const auto sooner = water_.at_parameter(std::span(around).first(1), kTime - kStep);
    const glm::dvec3 rate = (later[0].displacement - sooner[0].displacement) / (2.0 * kStep);
    EXPECT_NEAR(glm::length(p[0].velocity - rate), 0.0, 1e-6);
  }
}

// A wave that runs along w has <dh/dt dh/dw> < 0: what is to windward arrives later.
TEST_F(DirectSea, WavesRunWithTheWind) {
  double along = 0.0, against = 0.0, rate = 0.0, slope = 0.0;
  for (int i = 0; i < 400; ++i) {
    const std::vector<glm::dvec2> q = {glm::dvec2(13.1 * i, 7.7 * ((i * 37) % 400))};
    const auto p = water_.at_parameter(q, 50.0)[0];
    const double s = p.slope.x * 0.6 + p.slope.y * 0.8;
    along += p.velocity.y * s;
    against += p.velocity.y * (p.slope.x * 0.8 - p.slope.y * 0.6);
    rate += p.velocity.y * p.velocity.y;
    slope += s * s;
  }
  EXPECT_LT(along / std::sqrt(rate * slope), -0.5);
  EXPECT_LT(std::abs(against), 0.35 * std::abs(along));
}

double mean_height(const WaterSurface& water) {
  constexpr int kPlaces = 1000;
  double sum = 0.0;
  for (const double time : {10.0, 35.0, 60.0, 85.0}) {
    std::vector<glm::dvec2> places;
    for (int i = 0; i < kPlaces; ++i) places.emplace_back(11.3 * i, 5.9 * ((i * 29) % kPlaces));
    std::vector<WaterSample> samples(places.size());
    water.sample(places, time, samples);
    for (const auto& sample : samples) sum += sample.height;
  }
  return sum / (4.0 * kPlaces);
}

// Where crests are drawn together and troughs apart, a fixed place is in a trough more often: to
// first order its mean height is E[h (1 + div D)] = -choppiness sum k <h_k^2>. Rounded crests would
// turn the sign. The same places with and without, so that chance is in both.
TEST_F(DirectSea, CrestsAreSharperThanTroughs) {
  double expected = 0.0;
  for (const Cascade& cascade : cascades_) {
    for (int z = 0; z < cascade.size; ++z) {
      for (int x = 0; x < cascade.size; ++x) {
        const double amplitude2 =
            std::norm(cascade.h0[static_cast<std::size_t>(z * cascade.size + x)]);
        expected -= 0.9 * glm::length(cascade.wave_vector(x, z)) * 2.0 * amplitude2;
      }
    }
  }
  const double lowered = mean_height(water_) - mean_height(DirectWater(cascades_, 0.0));
  EXPECT_NEAR(lowered / expected, 1.0, 0.1);
}

TEST_F(DirectSea, SamplesMeetTheirPlace) {
  const std::vector<glm::dvec2> places = {{3.0, 4.0}, {1e6, -2e6}, {-50.5, 10.25}};
  std::vector<WaterSample> samples(places.size());
  water_.sample(places, 77.0, samples);
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_NEAR(glm::length(samples[i].normal), 1.0, 1e-12);
    // The normal agrees with the heights around.
    constexpr double kStep = 1e-3;
    const std::vector<glm::dvec2> around = {places[i] + glm::dvec2(kStep, 0),
                                            places[i] - glm::dvec2(kStep, 0)};
    std::vector<WaterSample> near(2);
    water_.sample(around, 77.0, near);
    const double slope = (near[0].height - near[1].height) / (2.0 * kStep);
    EXPECT_NEAR(-samples[i].normal.x / samples[i].normal.y, slope, 5e-3);
  }
}

TEST(SeaMesh, ReachesTheHorizonAndStaysWithinItsBudget) {
  // Looking level along -z: reversed depth, 60 degrees high, 16:9.
  glm::mat4 clip(0.0f);
  const float g = 1.0f / std::tan(0.5f * 1.047f);
  clip[0][0] = g * 9.0f / 16.0f;
  clip[1][1] = g;
  clip[2][3] = -1.0f;
  clip[3][2] = 0.15f;
  for (const double height : {2.0, 6.0, 100.0, 500.0}) {
    const SeaMesh mesh{.cells = 8, .finest_spacing = 0.375};
    const auto squares = mesh.select({1e6 + 0.3, -3e5}, height, 2.0, clip);
    EXPECT_LT(squares.size() * 81, 18000u) << height;
    double reach = 0.0;
    for (const auto& s : squares) {
      reach = std::max(reach, static_cast<double>(-s.y));
      // Corners lie on the world's grid: the same to within a float's rounding.
      const double x = (static_cast<double>(s.x) + 1e6 + 0.3) / s.z;
      EXPECT_NEAR(x, std::round(x), 1e-2);
    }
    EXPECT_GT(reach, SeaMesh::horizon(height)) << height;
  }
  EXPECT_NEAR(SeaMesh::horizon(2.0), 5048.0, 2.0);
}

}  // namespace
}  // namespace offing
