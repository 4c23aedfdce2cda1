// Barrel, crate and raft: the same hull code with other numbers.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <chrono>
#include <cmath>
#include <vector>

#include "boat_waters.h"
#include "engine/boat/floating_body.h"
#include "engine/core/angles.h"

namespace offing {
namespace {

constexpr double kStep = 1.0 / 120.0;

TEST(BoatFloating, ThingsFloatAtTheirDraughts) {
  const CalmWater water;
  const struct {
    FloatingThing thing;
    double area;  // m^2 of waterplane of the two boxes: draught = mass / (rho area)
  } kRows[] = {{crate(), 1.2 * 0.8}, {raft(), 3.0 * 2.0}};
  for (const auto& row : kRows) {
    FloatingBody body(row.thing);
    body.start({10.0, 20.0}, 0.4, water, 0.0);
    for (int i = 0; i < 20 * 120; ++i) body.step(water, i * kStep, kStep);
    const double draught = row.thing.parameters.mass / (kWaterDensity * row.area);
    EXPECT_NEAR(body.position().y, -draught, 1e-3);
    EXPECT_NEAR((body.orientation() * glm::dvec3(0, 1, 0)).y, 1.0, 1e-6);
    EXPECT_EQ(body.limit_hits(), 0);
  }
}

TEST(BoatFloating, ABarrelComesToRest) {
  const CalmWater water;
  FloatingBody body(barrel());
  body.start({0.0, 0.0}, 0.0, water, 0.0);
  for (int i = 0; i < 20 * 120; ++i) body.step(water, i * kStep, kStep);
  EXPECT_NEAR((body.orientation() * glm::dvec3(0, 1, 0)).y, 1.0, 1e-4);
  EXPECT_LT(glm::length(body.motion().velocity), 1e-3);
}

TEST(BoatFloating, ThingsRideASeaWithoutLimits) {
  const SineSea sea(2.0, 6.4, std::uint64_t{9});
  for (const FloatingThing& thing : {barrel(), crate(), raft()}) {
    FloatingBody body(thing);
    body.start({0.0, 0.0}, 0.0, sea, 0.0);
    double worst = 0.0;
    for (int i = 0; i < 120 * 60; ++i) {
      body.step(sea, i / 60.0, 1.0 / 60.0);
      const glm::dvec3 p = body.position();
      const glm::dvec2 place(p.x, p.z);
      WaterSample w;
      sea.sample({&place, 1}, (i + 1) / 60.0, {&w, 1});
      worst = std::max(worst, std::abs(p.y - w.height));
    }
    EXPECT_LT(worst, 1.0);
    EXPECT_EQ(body.limit_hits(), 0);
  }
}

TEST(BoatFloating, AHundredBarrelsAreCheap) {
  const CalmWater water;
  std::vector<FloatingBody> bodies;
  for (int i = 0; i < 100; ++i) {
    bodies.emplace_back(barrel());
    bodies.back().start({2.0 * i, 0.0}, 0.1 * i, water, 0.0);
  }
  double best = 1e9;
  for (int round = 0; round < 20; ++round) {
    const auto begin = std::chrono::steady_clock::now();
    for (FloatingBody& body : bodies) body.step(water, round * kStep, kStep);
    const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - begin;
    best = std::min(best, spent.count());
  }
  RecordProperty("milliseconds_per_step_of_100", std::to_string(best));
#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  EXPECT_LT(best, 1.0);
#endif
}

}  // namespace
}  // namespace offing
