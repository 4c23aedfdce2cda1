#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <cmath>
#include <thread>

#include "engine/ocean/direct_water.h"
#include "engine/ocean/fft_moments.h"
#include "engine/ocean/sea_water.h"

namespace offing {
namespace {

std::vector<Cascade> cascades_of(double wind, std::uint64_t seed, int size = 128,
                                 const SeaState& state = {}) {
  const SeaSpectrum spectrum(state, wind, {0.6, 0.8});
  std::vector<Cascade> cascades;
  for (const CascadeBand& band : choose_bands(spectrum, 2, size)) {
    cascades.push_back(make_cascade(spectrum, band, size, seed, static_cast<int>(cascades.size())));
  }
  return cascades;
}

std::unique_ptr<SeaWater> fft_water(const std::vector<Cascade>& cascades, double choppiness) {
  auto water = std::make_unique<SeaWater>(std::make_unique<FftMoments>());
  water->set_waves(std::make_shared<QueryWaves>(cascades, static_cast<int>(cascades.size())),
                   choppiness, INFINITY);
  return water;
}

std::vector<glm::dvec2> scattered(int count) {
  std::vector<glm::dvec2> places;
  for (int i = 0; i < count; ++i) places.emplace_back(17.31 * i - 300.0, 1e5 - 23.7 * i);
  return places;
}

struct Errors {
  double height = 0.0, worst = 0.0, normal = 0.0, velocity = 0.0;
};
Errors compare(const WaterSurface& water, const WaterSurface& truth, double time, int count) {
  const auto places = scattered(count);
  std::vector<WaterSample> got(places.size()), want(places.size());
  water.sample(places, time, got);
  truth.sample(places, time, want);
  Errors errors;
  for (std::size_t i = 0; i < places.size(); ++i) {
    errors.height += std::pow(got[i].height - want[i].height, 2);
    errors.worst = std::max(errors.worst, std::abs(got[i].height - want[i].height));
    errors.normal += std::pow(glm::length(got[i].normal - want[i].normal), 2);
    errors.velocity += std::pow(glm::length(got[i].velocity - want[i].velocity), 2);
  }
  for (double* sum : {&errors.height, &errors.normal, &errors.velocity}) {
    *sum = std::sqrt(*sum / count);
  }
  return errors;
}

TEST(SeaWater, AgreesWithTheDirectSumAtAnyTime) {
  SeaState state;
  state.swell = {.height = 3.0, .period = 11.0, .from_deg = 280.0};
  const auto cascades = cascades_of(12.0, 5, 128, state);  // Hs 4 m
  const auto water = fft_water(cascades, 1.0);
  const DirectWater direct(cascades, 1.0);
  for (const double time : {0.0, 1000.03, 2592000.777, -12.34}) {
    const Errors errors = compare(*water, direct, time, 150);
    EXPECT_LT(errors.height, 0.004) << time;
    EXPECT_LT(errors.worst, 0.03) << time;
    EXPECT_LT(errors.normal, 0.01) << time;
    EXPECT_LT(errors.velocity, 0.03) << time;
    EXPECT_EQ(water->age(time), 0.0);
  }
}

// In 5 m of water the waves' sideways motion is coth kh times their height.
TEST(SeaWater, FeelsTheBottom) {
  SeaState state;
  state.spectrum = kTma;
  state.depth_m = 5.0;
  const auto cascades = cascades_of(9.0, 2, 128, state);
  const DirectWater direct(cascades, 0.7);
  const Errors errors = compare(*fft_water(cascades, 0.7), direct, 55.5, 60);
  EXPECT_LT(errors.height, 0.002);
  double up = 0.0, sideways = 0.0, expected = 0.0;
  const auto points = direct.at_parameter(scattered(2000), 3.0);
  for (const DirectPoint& p : points) {
    up += p.displacement.y * p.displacement.y / 2000.0;
    sideways +=
        (p.displacement.x * p.displacement.x + p.displacement.z * p.displacement.z) / 2000.0;
  }
  double energy = 0.0;
  for (const Cascade& c : cascades) {
    for (int z = 0; z < c.size; ++z) {
      for (int x = 0; x < c.size; ++x) {
        const double e = 2.0 * std::norm(c.h0[static_cast<std::size_t>(z * c.size + x)]);
        if (e == 0.0) continue;
        energy += e;
        expected += 0.49 * e / std::pow(std::tanh(5.0 * glm::length(c.wave_vector(x, z))), 2.0);
      }
    }
  }
  EXPECT_GT(expected / energy, 1.2 * 0.49);  // shallow enough to matter
  EXPECT_NEAR(sideways / up / (expected / energy), 1.0, 0.1);
}

TEST(SeaWater, IsTheSameFromAnyThreadAndInAnyOrder) {
  const auto cascades = cascades_of(9.0, 2);
  const auto water = fft_water(cascades, 1.0), other = fft_water(cascades, 1.0);
  const auto places = scattered(20);
  std::vector<std::vector<WaterSample>> forward(40, std::vector<WaterSample>(places.size()));
  for (int i = 0; i < 40; ++i)
    water->sample(places, 0.05 * i, forward[static_cast<std::size_t>(i)]);
  const auto backward = [&](int first) {
    for (int i = first; i >= 0; i -= 2) {
      std::vector<WaterSample> now(places.size());
      other->sample(places, 0.05 * i, now);
      for (std::size_t p = 0; p < places.size(); ++p) {
        EXPECT_EQ(now[p].height, forward[static_cast<std::size_t>(i)][p].height);
      }
    }
  };
  std::thread even([&] { backward(38); });
  std::thread odd([&] { backward(39); });
  even.join();
  odd.join();
}

// The boat must feel no jump while one sea turns into another, be it a little higher on the same
// grid or so much longer that all patches change.
TEST(SeaWater, SeasFadeOverWithoutAJump) {
  for (const double wind : {9.3, 33.0}) {
    const auto old = cascades_of(9.0, 2), fresh = cascades_of(wind, 2);
    EXPECT_EQ(same_grid(old[0], fresh[0]), wind < 10.0);
    const auto water = fft_water(old, 1.0), before = fft_water(old, 1.0);
    const auto after = fft_water(fresh, 0.6);
    water->set_waves(std::make_shared<QueryWaves>(fresh, 2), 0.6, 20.25);
    const auto places = scattered(30);
    std::vector<WaterSample> now(places.size()), last(places.size()), alone(places.size());
    constexpr double kStep = 1.0 / 480.0;
    water->sample(places, 20.0, last);
    before->sample(places, 20.0, alone);
    for (std::size_t p = 0; p < places.size(); ++p) EXPECT_EQ(last[p].height, alone[p].height);
    for (double time = 20.0 + kStep; time < 21.5; time += kStep) {
      water->sample(places, time, now);
      for (std::size_t p = 0; p < places.size(); ++p) {
        // A place's height changes with the vertical speed of what is there and with the slope
        // that passes by, and with the ramp, 1.5 / .5 s of some 12 m: a jump would be metres.
        EXPECT_LT(std::abs(now[p].height - last[p].height), 50.0 * kStep) << time;
        // The ramp's own acceleration, 6 / .5² of some 10 m at most, and the waves'.
        EXPECT_LT(glm::length(now[p].velocity - last[p].velocity), 250.0 * kStep) << time;
      }
      last = now;
    }
    after->sample(places, 21.5, alone);
    water->sample(places, 21.5, now);
    for (std::size_t p = 0; p < places.size(); ++p) EXPECT_EQ(now[p].height, alone[p].height);
  }
}

// A source that stops at some moment, as read-backs that fail to come.
class LateMoments final : public MomentSource {
 public:
  explicit LateMoments(std::int64_t last) : last_(last) {}
  void take(const std::shared_ptr<const QueryWaves>& waves) override { all_.take(waves); }
  MomentPair around(const std::shared_ptr<const QueryWaves>& waves, std::int64_t index) override {
    if (index < last_) return all_.around(waves, index);
    return {all_.around(waves, last_).before, nullptr};
  }

 private:
  std::int64_t last_;
  FftMoments all_;
};

TEST(SeaWater, LateWaterIsCarriedOnThenFlattened) {
  const auto cascades = cascades_of(12.0, 4);
  SeaWater water(std::make_unique<LateMoments>(80));  // nothing after 10 s
  EXPECT_TRUE(water.stale(0.0));                      // nothing at all yet
  water.set_waves(std::make_shared<QueryWaves>(cascades, 2), 1.0, INFINITY);
  const DirectWater direct(cascades, 1.0);
  EXPECT_EQ(water.age(9.9), 0.0);
  EXPECT_NEAR(water.age(10.2), 0.2, 1e-12);
  EXPECT_FALSE(water.stale(10.2));
  EXPECT_TRUE(water.stale(10.3));
  EXPECT_LT(compare(water, direct, 10.05, 100).height, 0.01);  // 50 ms late
  const auto places = scattered(50);
  std::vector<WaterSample> now(places.size()), last(places.size());
  water.sample(places, 9.99, last);
  double height = 0.0;
  for (double time = 10.0; time < 11.5; time += 0.01) {
    water.sample(places, time, now);
    height = 0.0;
    for (std::size_t p = 0; p < places.size(); ++p) {
      EXPECT_LT(std::abs(now[p].height - last[p].height), 0.1) << time;
      height = std::max(height, std::abs(now[p].height));
    }
    last = now;
  }
  EXPECT_EQ(height, 0.0);
  EXPECT_EQ(glm::length(now[0].velocity), 0.0);
}

}  // namespace
}  // namespace offing
