#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/clouds/gardner.h"

#define OFFING_GLSL "shaders/lib/gardner.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {
using namespace glsl;

TEST(GardnerTexture, LiesBetweenZeroAndOneAndRepeatsAfterTwoWavelengths) {
  double least = 1.0, most = 0.0;
  for (int i = 0; i < 4000; ++i) {
    const vec3 p(0.137 * i, 0.0911 * i + 0.3, 0.053 * i);
    const double value = gardner_texture(p, 7, 1.0, 0.0);
    least = std::min(least, value);
    most = std::max(most, value);
    EXPECT_NEAR(gardner_texture(p + vec3(2.0, 0.0, 0.0), 7, 1.0, 0.0), value, 1e-9);
    EXPECT_NEAR(gardner_texture(p + vec3(0.0, -4.0, 2.0), 7, 1.0, 0.0), value, 1e-9);
  }
  EXPECT_GE(least, 0.0);
  EXPECT_LE(most, 1.0);
  EXPECT_LT(least, 0.08);
  EXPECT_GT(most, 0.55);
}

TEST(GardnerTexture, OneTermIsItsProductOfSines) {
  // (3) with n = 1, T0 = 1 and the phases (6): k = 1 / 4.
  const double x = 0.21, y = 0.34;
  const double px = kGardnerPi / 2.0 * std::sin(kGardnerPi * y);
  const double py = kGardnerPi / 2.0 * std::sin(kGardnerPi * x);
  EXPECT_NEAR(gardner_texture({x, y, 0.0}, 1, 1.0, 0.0),
              0.25 * (std::sin(2.0 * kGardnerPi * x + px) + 1.0) *
                  (std::sin(2.0 * kGardnerPi * y + py) + 1.0),
              1e-12);
}

TEST(GardnerTexture, LosesWhatSamplesCannotCarry) {
  // Samples half a wavelength of the second term apart: only the first is left of its own sines.
  const auto deviation = [](double footprint) {
    double sum = 0.0, squares = 0.0;
    constexpr int kSide = 64;
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        const double v =
            gardner_texture({2.0 * x / kSide, 2.0 * y / kSide, 0.0}, 7, 1.0, footprint);
        sum += v;
        squares += v * v;
      }
    }
    const double mean = sum / (kSide * kSide);
    return std::sqrt(squares / (kSide * kSide) - mean * mean);
  };
  EXPECT_LT(deviation(0.1), deviation(0.0));
  EXPECT_LT(deviation(0.3), deviation(0.1));
  EXPECT_NEAR(deviation(0.5), 0.0, 1e-9);
}

TEST(GardnerTexture, CoversTheShareThatItsThresholdSays) {
  const std::vector<double> values = gardner_values(7, 1.0);
  for (const double share : {0.1, 0.5, 0.8}) {
    const auto rank =
        static_cast<std::size_t>((1.0 - share) * static_cast<double>(values.size() - 1));
    int covered = 0;
    constexpr int kSide = 150;  // other places than those of the table
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        const double v = gardner_texture({2.0 * x / kSide, 2.0 * y / kSide, 0.0}, 7, 1.0, 0.0);
        covered += gardner_translucency(v, values[rank], 0.4) < 1.0 ? 1 : 0;
      }
    }
    EXPECT_NEAR(covered / static_cast<double>(kSide * kSide), share, 0.02) << share;
  }
}

TEST(GardnerShading, IsLinearInItsShares) {
  EXPECT_NEAR(gardner_shade(0.6, 0.3, 0.8, 0.2, 0.4, 0.1),
              0.8 * (0.6 * (0.9 * 0.6 + 0.1 * 0.3) + 0.4 * 0.8) + 0.2, 1e-12);
  EXPECT_EQ(gardner_translucency(0.3, 0.3, 0.1), 1.0);
  EXPECT_NEAR(gardner_translucency(0.35, 0.3, 0.1), 0.5, 1e-12);
  EXPECT_EQ(gardner_translucency(0.5, 0.3, 0.1), 0.0);
  // In the middle T1 counts, at the outline T2.
  EXPECT_NEAR(gardner_limb_translucency(0.2, 1.0, 0.15, 0.4, 0.1), 0.5, 1e-12);
  EXPECT_NEAR(gardner_limb_translucency(0.45, 0.0, 0.15, 0.4, 0.1), 0.5, 1e-12);
}

TEST(GardnerHit, FindsTheEllipsoid) {
  // From 5 m off a sphere of 1 straight at it, past its edge, and beside it.
  const GardnerHit straight = gardner_hit({0.0, 0.0, 5.0}, {0.0, 0.0, -2.0});
  EXPECT_NEAR(straight.limb, 1.0, 1e-12);
  EXPECT_NEAR(straight.along, 2.0, 1e-12);
  EXPECT_NEAR(gardner_hit({1.0, 0.0, 5.0}, {0.0, 0.0, -1.0}).limb, 0.0, 1e-12);
  EXPECT_LT(gardner_hit({1.5, 0.0, 5.0}, {0.0, 0.0, -1.0}).limb, 0.0);
}

TEST(GardnerCumuli, DriftWithTheWindAndComeFarthestFirst) {
  GardnerView view;
  view.weather.cover = 0.6;
  const std::vector<GardnerEllipsoid> here = gardner_cumuli(view);
  ASSERT_GT(here.size(), 50u);
  for (std::size_t i = 1; i < here.size(); ++i) {
    EXPECT_GE(glm::length(here[i - 1].centre), glm::length(here[i].centre));
  }
  // Carried as far as the camera has gone, they look the same.
  view.low_carried = {12345.0, -6789.0};
  view.eye = {12345.0, 0.0, -6789.0};
  const std::vector<GardnerEllipsoid> along = gardner_cumuli(view);
  ASSERT_EQ(along.size(), here.size());
  EXPECT_NEAR(along.back().centre.x, here.back().centre.x, 0.01);
  view.weather.cover = 0.0;
  EXPECT_TRUE(gardner_cumuli(view).empty());
}

}  // namespace
}  // namespace offing
