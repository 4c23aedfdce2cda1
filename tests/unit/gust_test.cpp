#include "engine/environment/gust_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "engine/core/random.h"
#include "engine/environment/environment.h"

namespace offing {
namespace {

TEST(GustField, MeanVarianceAndPeriod) {
  const GustField& field = gust_field();
  double sum = 0.0, sum2 = 0.0;
  constexpr int kPoints = 40000;
  for (unsigned i = 0; i < kPoints; ++i) {
    const glm::dvec2 p(GustField::kPeriod * random_uniform(3, 0, i),
                       GustField::kPeriod * random_uniform(3, 1, i));
    const double value = field.at(p);
    sum += value;
    sum2 += value * value;
    if (i < 100) {
      EXPECT_NEAR(field.at(p + GustField::kPeriod * glm::dvec2(3.0, -7.0)), value, 1e-6);
      EXPECT_NEAR(field.at(p + GustField::kPeriod * glm::dvec2(-1e6, 1e6)), value, 1e-3);
    }
  }
  EXPECT_NEAR(sum / kPoints, 0.0, 0.03);   // correlated points: 4 sigma
  EXPECT_NEAR(sum2 / kPoints, 1.0, 0.06);  // interpolation takes some 2 % away
}

TEST(GustField, GridCellCentresAreTheGrid) {
  const GustField& field = gust_field();
  ASSERT_EQ(field.grid().size(), 512u * 512u);
  EXPECT_NEAR(field.at({(3 + 0.5) * 8.0, (17 + 0.5) * 8.0}), field.grid()[17 * 512 + 3], 1e-6);
  EXPECT_NEAR(field.at({-4.0, -4.0}), field.grid()[511 * 512 + 511], 1e-6);
}

TEST(GustField, FallsOffAsVonKarman) {
  // The structure function of the 1-D von Kármán spectrum in its inertial range rises as d^(2/3).
  const GustField& field = gust_field();
  const auto structure = [&](double d) {
    double sum = 0.0;
    for (unsigned i = 0; i < 40000; ++i) {
      const glm::dvec2 p(4096.0 * random_uniform(5, 0, i), 4096.0 * random_uniform(5, 1, i));
      const double step = field.at(p + glm::dvec2(d, 0.0)) - field.at(p);
      sum += step * step;
    }
    return sum / 40000;
  };
  const double slope = std::log(structure(120.0) / structure(60.0)) / std::log(2.0);
  EXPECT_GT(slope, 0.5);
  EXPECT_LT(slope, 0.95);                    // smoothing over 3 s steepens it a little
  EXPECT_NEAR(structure(1500.0), 2.0, 0.3);  // far apart: uncorrelated
}

TEST(Wind, ThreeSecondGustOfTenMinutesIsAQuarterMore) {
  Environment e;
  e.wind = {10.0, 250.0, 1.0};
  double mean_peak = 0.0;
  constexpr int kRuns = 12;
  for (int run = 0; run < kRuns; ++run) {
    const glm::dvec2 place(331.0 * run, 997.0 * run);
    e.set_elapsed(0.0);
    double window[30] = {}, sum = 0.0, peak = 0.0;
    for (int i = 0; i < 6000; ++i) {  // every 0.1 s
      const double speed = glm::length(e.wind_at(place, 10.0));
      sum += speed - window[i % 30];
      window[i % 30] = speed;
      if (i >= 30) peak = std::max(peak, sum / 30.0);
      e.advance(0.1);
    }
    mean_peak += peak / kRuns;
  }
  EXPECT_NEAR(mean_peak / 10.0, 1.25, 0.05);
}

TEST(Wind, GustsAreCarriedByTheWind) {
  Environment e;
  e.wind = {7.0, 310.0, 0.8};
  const glm::dvec2 place(12.5, -340.0);
  const double before = e.gust_factor(place);
  for (int i = 0; i < 1200; ++i) e.advance(1.0 / 120.0);
  EXPECT_NEAR(e.gust_factor(place + 10.0 * e.wind_velocity()), before, 1e-9);
  EXPECT_NE(e.gust_factor(place), before);
}

TEST(Wind, TurningTheWindDoesNotJump) {
  Environment e;
  e.wind = {9.0, 200.0, 1.0};
  for (int i = 0; i < 4000; ++i) e.advance(1.0);  // over an hour: far downwind
  const double before = e.gust_factor({5.0, 5.0});
  e.wind.from_deg = 205.0;
  e.advance(1.0 / 120.0);
  EXPECT_NEAR(e.gust_factor({5.0, 5.0}), before, 0.01);
}

TEST(Wind, ProfileAndDirection) {
  Environment e;
  e.wind = {10.0, 0.0, 0.0};
  const glm::dvec2 north_wind = e.wind_at({0.0, 0.0}, 10.0);
  EXPECT_NEAR(north_wind.x, 0.0, 1e-12);
  EXPECT_NEAR(north_wind.y, 10.0, 1e-12);  // from the north: toward +z, the south
  e.wind.from_deg = 90.0;
  EXPECT_NEAR(e.wind_at({0.0, 0.0}, 10.0).x, -10.0, 1e-12);  // from the east: toward the west
  EXPECT_NEAR(glm::length(e.wind_at({0.0, 0.0}, 2.0)) / 10.0, 0.79, 0.005);
  EXPECT_NEAR(glm::length(e.wind_at({0.0, 0.0}, 4.6)) / 10.0, 0.898, 0.005);
  EXPECT_EQ(e.wind_at({0.0, 0.0}, -3.0), e.wind_at({0.0, 0.0}, 0.05));
  EXPECT_GT(glm::length(e.wind_at({0.0, 0.0}, 0.0)), 0.0);
}

TEST(Wind, IsCheapToAsk) {
  Environment e;
  e.wind.gusts = 1.0;
  glm::dvec2 sum = e.wind_at({0.0, 0.0}, 5.0);  // makes the field
  double best = 1e9;
  for (int run = 0; run < 5; ++run) {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < 10000; ++i) sum += e.wind_at({0.37 * i, 0.11 * i}, 5.0);
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;
    best = std::min(best, took.count() / 10000);
  }
  EXPECT_GT(glm::length(sum), 0.0);
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  EXPECT_LT(best, 0.3) << "microseconds";
#endif
}

}  // namespace
}  // namespace offing
