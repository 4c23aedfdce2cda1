#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <chrono>
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
TEST(SeaWater, Prints) {
  SeaState state;
  state.swell = {.height = 3.0, .period = 11.0, .from_deg = 280.0};
  const auto cascades = cascades_of(12.0, 5, 128, state);  // Hs 4 m
  const auto water = fft_water(cascades, 1.0);
  const DirectWater direct(cascades, 1.0);
  for (const double time : {0.0, 1000.03, 2592000.777, -12.34}) {
    const Errors e = compare(*water, direct, time, 300);
    printf("%g %g %g %g\n", e.height, e.worst, e.normal, e.velocity);
  }
  const auto places = scattered(4096);
  std::vector<WaterSample> got(places.size());
  for (int i = 0; i < 10; ++i) {
    const auto t0 = std::chrono::steady_clock::now();
    water->sample(places, 0.125*i+0.03, got);
    const auto t1 = std::chrono::steady_clock::now();
    water->sample(places, 0.125*i+0.04, got);
    const auto t2 = std::chrono::steady_clock::now();
    printf("%g %g ms\n", std::chrono::duration<double>(t1-t0).count()*1e3, std::chrono::duration<double>(t2-t1).count()*1e3);
  }
}

}  // namespace
}  // namespace offing
