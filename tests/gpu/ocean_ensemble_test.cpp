#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/core/angles.h"
#include "engine/core/random.h"
#include "engine/ocean/direct_water.h"
#include "engine/ocean/fft_moments.h"
#include "engine/ocean/gpu_moments.h"
#include "engine/ocean/ocean.h"
#include "engine/ocean/ocean_export.h"
#include "engine/ocean/sea_measurement.h"
#include "game/world/random_sea.h"
#include "support/graph_test.h"

namespace offing {
namespace {

class OceanEnsemble : public test::GraphTest {
 protected:
  /// A frame in which somebody looks at the sea.
  void look(Ocean& ocean, double time) {
    graph_->begin_frame();
    const SeaIds ids = ocean.add_maps(*graph_, time);
    graph_->add(
        "look",
        [&](PassBuilder& pass) { pass.read(ids.displacement).read(ids.slopes).side_effect(); },
        [](PassContext&) {});
    graph_->execute();
    ocean.collect();
  }
};

/// The frequency weighted by the fourth power of a density, which stands for its peak (Delft).
template <class Energy>
double delft_peak(const Energy& energy_in_bin, double bin) {
  double weight = 0.0, moment = 0.0;
  for (int i = 1; i * bin < 8.0; ++i) {
    const double fourth = std::pow(energy_in_bin(i), 4.0);
    weight += fourth;
    moment += fourth * (i + 0.5) * bin;
  }
  return moment / weight;
}

TEST_F(OceanEnsemble, TheDisplayedSeaHasHeightDirectionAndPeriodOfItsSpectrum) {
  constexpr int kSeeds = 16;
  constexpr double kBin = 0.08;  // rad/s
  for (const int spectrum : {kPiersonMoskowitz, kJonswap, kTma}) {
    Ocean ocean(*shaders_, {.cascades = 3, .size = 64});
    Environment environment;
    environment.wind.speed = 10.0;
    environment.wind.from_deg = 250.0;
    SeaState state;
    state.spectrum = spectrum;
    state.depth_m = spectrum == kTma ? 20.0 : 1000.0;
    state.swell.height = 0.0;
    double variance = 0.0, expected = 0.0, xx = 0.0, zz = 0.0, xz = 0.0;
    std::map<int, double> energy;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      ocean.set_sea(state, environment, seed);
      const auto maps = export_cascades(ocean, *graph_, 40.0);
      expected += ocean.carried_variance() / kSeeds;
      for (std::size_t c = 0; c < maps.size(); ++c) {
        variance += maps[c].variance / kSeeds;
        for (std::size_t i = 0; i < maps[c].dx.size(); ++i) {
          xx += static_cast<double>(maps[c].dx[i] * maps[c].dx[i]);
          zz += static_cast<double>(maps[c].dz[i] * maps[c].dz[i]);
          xz += static_cast<double>(maps[c].dx[i] * maps[c].dz[i]);
        }
      }
      const SeaMeasurement sea =
          measure_sea(ocean.cascades(), ocean.maps().displacement().read_floats(4));
      EXPECT_NEAR(sea.hs / (4.0 * std::sqrt(ocean.carried_variance())), 1.0, 0.1) << seed;
      for (const Cascade& cascade : ocean.cascades()) {
        for (std::size_t i = 0; i < cascade.h0.size(); ++i) {
          energy[static_cast<int>(cascade.frequency[i] / kBin)] += 2.0 * std::norm(cascade.h0[i]);
        }
      }
    }
    EXPECT_NEAR(variance / expected, 1.0, 0.02) << spectrum;
    // Water moves to and fro along the way the waves go: the main axis of that motion.
    const double axis = 0.5 * std::atan2(2.0 * xz, xx - zz);
    const glm::dvec2 wind = environment.wind_to();
    const double off = std::remainder(axis - std::atan2(wind.y, wind.x), kPi);
    EXPECT_LT(std::abs(degrees(off)), 2.0) << spectrum;
    const SeaSpectrum continuous(state, 10.0, wind);
    const double got = delft_peak([&](int i) { return energy[i]; }, kBin);
    const double want = delft_peak(
        [&](int i) {
          double sum = 0.0;
          for (int j = 0; j < 20; ++j) sum += continuous.frequency_density((i + 0.05 * j) * kBin);
          return sum;
        },
        kBin);
    EXPECT_NEAR(got / want, 1.0, 0.03) << spectrum;
  }
}

// Any combination of points of the three incommensurate patches lies side by side somewhere.
TEST_F(OceanEnsemble, NoFoldAtTheDefaultChoppinessBelowTwelveMetresASecond) {
  Ocean ocean(*shaders_, {.cascades = 3, .size = 128});
  Environment environment;
  environment.wind.speed = 11.9;
  ocean.set_sea({}, environment, 5);
  look(ocean, 12.0);
  const auto displacement = ocean.maps().displacement().read_floats(4);
  const auto slopes = ocean.maps().slopes().read_floats(4);
  constexpr std::size_t kLayer = 128 * 128;
  constexpr int kPlaces = 500000;
  int folds = 0;
  for (int i = 0; i < kPlaces; ++i) {
    double dxx = 0.0, dzz = 0.0, dxz = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t at =
          4 * (c * kLayer + random_bits(1, c, static_cast<std::uint64_t>(i)) % kLayer);
      dxx += static_cast<double>(slopes[at + 2]);
      dzz += static_cast<double>(slopes[at + 3]);
      dxz += static_cast<double>(displacement[at + 3]);
    }
    if ((1.0 + dxx) * (1.0 + dzz) - dxz * dxz <= 0.0) ++folds;
  }
  EXPECT_EQ(folds, 0);
}

TEST_F(OceanEnsemble, TheGpuSendsBackTheMomentsThatFftwMakes) {
  Environment environment;
  environment.wind.speed = 11.0;
  SeaState state;
  state.queries = kReadbackQueries;
  Ocean ocean(*shaders_, {.cascades = 3, .size = 64});
  ocean.set_sea(state, environment, 9);
  ocean.prime(*graph_, 1000.0);
  state.queries = kDirectQueries;
  Ocean other(*shaders_, {.cascades = 3, .size = 64});
  other.set_sea(state, environment, 9);
  std::vector<glm::dvec2> places;
  for (int i = 0; i < 60; ++i) places.emplace_back(17.31 * i - 300.0, 1e5 - 23.7 * i);
  std::vector<WaterSample> got(places.size()), want(places.size());
  for (int frame = 0; frame < 40; ++frame) {  // from 20 to 240 frames a second
    const double time = 1000.0 + 0.0008 * frame * frame;
    ocean.water().sample(places, time, got);
    other.water().sample(places, time, want);
    EXPECT_EQ(ocean.water().age(time), 0.0) << frame;
    for (std::size_t i = 0; i < places.size(); ++i) {
      EXPECT_NEAR(got[i].height, want[i].height, 2e-5) << frame;
      EXPECT_NEAR(got[i].velocity.y, want[i].velocity.y, 1e-4) << frame;
    }
    look(ocean, time);
    glFinish();
  }
  ocean.water().sample(places, 2000.0, got);  // nobody has asked for that time
  EXPECT_TRUE(ocean.water().stale(2000.0));
  EXPECT_EQ(got[7].height, 0.0);
}

// Half-way through a change the picture shows the waves that floating things feel.
TEST_F(OceanEnsemble, PictureAndWaterFadeTogether) {
  Environment environment;
  environment.wind.speed = 8.0;
  Ocean ocean(*shaders_, {.cascades = 2, .size = 64});
  ocean.set_sea({}, environment, 9);
  const double start = 50.0;
  for (const double wind : {8.2, 33.0}) {
    environment.wind.speed = wind;
    const double begin = start + (wind > 10.0 ? 10.0 : 0.0);
    ocean.turn_to({}, environment, 9, begin);
    for (const double time : {begin + 0.5, begin + 0.6, begin + 0.95, begin + 1.3}) {
      look(ocean, time);
      const DirectWater shown(ocean.cascades(), ocean.choppiness());
      std::vector<glm::dvec2> places;
      for (int i = 0; i < 40; ++i) places.emplace_back(7.3 * i, -3.1 * i);
      std::vector<WaterSample> got(places.size()), want(places.size());
      ocean.water().sample(places, time, got);
      shown.sample(places, time, want);
      for (std::size_t i = 0; i < places.size(); ++i) {
        // Waves of four points are 1.2 % off in queries.
        EXPECT_NEAR(got[i].height, want[i].height, 0.01 + 0.01 * ocean.statistics().hs)
            << wind << " " << time;
      }
    }
    EXPECT_DOUBLE_EQ(ocean.statistics().hs,
                     SeaSpectrum({}, wind, environment.wind_to()).statistics().hs);
  }
}

TEST_F(OceanEnsemble, RandomSeasAreFiniteAndLeaveNothingBehind) {
  Ocean ocean(*shaders_, {.cascades = 3, .size = 64});
  const auto buffers = [] {
    int count = 0;
    for (GLuint name = 1; name < 512; ++name) count += glIsBuffer(name) + glIsTexture(name);
    return count;
  };
  int before = 0;
  for (int i = 0; i < 24; ++i) {
    RandomSea sea = random_sea(1, i);
    sea.state.queries = i % 8 == 7 ? kReadbackQueries : kDirectQueries;
    ocean.set_sea(sea.state, sea.environment, static_cast<std::uint64_t>(i));
    look(ocean, sea.time);
    for (const gl::Texture* map : {&ocean.maps().displacement(), &ocean.maps().slopes()}) {
      for (const float value : map->read_floats(4)) ASSERT_TRUE(std::isfinite(value)) << i;
    }
    const std::vector<glm::dvec2> places = {{0.0, 0.0}, {1e6, -3e5}};
    std::vector<WaterSample> samples(2);
    ocean.water().sample(places, sea.time, samples);
    for (const WaterSample& s : samples) {
      ASSERT_TRUE(std::isfinite(s.height + s.normal.y + s.velocity.x + s.velocity.y)) << i;
    }
    if (i == 8) before = buffers();
  }
  ocean.set_sea({}, Environment{}, 1);
  EXPECT_LE(buffers(), before);
}

}  // namespace
}  // namespace offing
