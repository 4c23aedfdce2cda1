#include <gtest/gtest.h>

#include <cmath>

#include "engine/post/tonemap.h"

#define OFFING_GLSL "shaders/lib/colour.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/tonemap.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {
using namespace glsl;

TEST(Srgb, KnownPoints) {
  EXPECT_EQ(srgb_from_linear(0.0), 0.0);
  EXPECT_NEAR(srgb_from_linear(1.0), 1.0, 1e-12);
  EXPECT_NEAR(srgb_from_linear(0.0031308), 0.04045, 1e-5);  // where the pieces meet
  EXPECT_NEAR(srgb_from_linear(0.18), 0.46135612950, 1e-9);
  EXPECT_NEAR(srgb_from_linear(0.5), 0.73535698, 1e-7);
  EXPECT_NEAR(linear_from_srgb(0.5), 0.21404114, 1e-7);
  for (double x = 0.0; x <= 1.0; x += 0.01) {
    EXPECT_NEAR(linear_from_srgb(srgb_from_linear(x)), x, 1e-7);
  }
}

TEST(Filmic, IsSmoothMonotoneAndEndsInWhite) {
  EXPECT_EQ(filmic_curve(0.0), 0.0);
  double last = 0.0, last_slope = -1.0;
  for (double x = 0.001; x < 12.0; x += 0.001) {
    const double y = filmic_curve(x), slope = (y - last) / 0.001;
    EXPECT_GE(y, last) << x;
    EXPECT_LE(y, 1.0);
    if (x > 0.02) {  // the toe is a power, steeply changing at 0 itself
      EXPECT_LT(std::abs(slope - last_slope), 0.03) << x;  // no kink
    }
    last = y;
    last_slope = slope;
  }
  EXPECT_NEAR(filmic_curve(0.3), 0.3, 1e-9);  // straight in the middle
  EXPECT_GT(filmic_curve(12.0), 0.999);
  const vec3 fire = tonemap_filmic(vec3(200.0, 20.0, 0.0));
  EXPECT_GT(fire.z, 0.95);  // far too bright a colour ends in white
}

TEST(Filmic, IsDrawnWithinAQuarterOfAStep) {
  double last = 0.0;
  for (double x = 0.0; x < 1.0e4; x += 1e-5 + 1e-3 * x) {
    const double shown = filmic_display(x);
    EXPECT_NEAR(shown, srgb_from_linear(filmic_curve(x)), 0.25 / 255.0) << x;
    EXPECT_GT(shown, last - 0.45 / 255.0) << x;  // where the pieces meet
    last = std::max(last, shown);
  }
}

TEST(Exponential, KnownPoints) {
  EXPECT_NEAR(tonemap_exponential(vec3(1.0, 0.0, 100.0)).x, 1.0 - std::exp(-1.0), 1e-12);
  EXPECT_EQ(tonemap_exponential(vec3(0.0)).x, 0.0);
  EXPECT_NEAR(tonemap_exponential(vec3(100.0)).z, 1.0, 1e-12);
}

TEST(NightSight, WhiteKeepsItsLuminanceAndRedGoesDark) {
  EXPECT_NEAR(scotopic_luminance(vec3(0.4)), 0.4, 0.002);
  EXPECT_LT(scotopic_luminance(vec3(1, 0, 0)), 0.3 * colour_luminance(vec3(1, 0, 0)));
  EXPECT_GT(scotopic_luminance(vec3(0, 0, 1)), 2.0 * colour_luminance(vec3(0, 0, 1)));
  EXPECT_EQ(rod_share(1000.0), 0.0);
  EXPECT_EQ(rod_share(1e-4), 1.0);
  EXPECT_NEAR(rod_share(0.1), 0.5, 0.001);
  EXPECT_NEAR(colour_luminance(night_sight(vec3(0.2), 1.0)), 0.2, 0.001);
  const vec3 day(0.3, 0.2, 0.1);
  EXPECT_EQ(night_sight(day, 0.0), day);
}

TEST(NightSight, BlueOutshinesRedByMoonlight) {
  // Purkinje's shift: two patches of one luminance, in daylight and under the moon, each shown at
  // an exposure that makes that luminance 0.2.
  const vec3 red = vec3(0.6, 0.1, 0.1) / colour_luminance(vec3(0.6, 0.1, 0.1));
  const vec3 blue = vec3(0.1, 0.1, 0.6) / colour_luminance(vec3(0.1, 0.1, 0.6));
  const auto shown = [](const vec3& patch, double luminance) {
    return tonemap_filmic(night_sight(0.2 * patch, rod_share(luminance)));
  };
  const auto blue_over_red = [&](double luminance) {
    return colour_luminance(shown(blue, luminance)) / colour_luminance(shown(red, luminance));
  };
  const auto saturation = [&](const vec3& patch, double luminance) {
    const vec3 c = shown(patch, luminance);
    const double most = std::max({c.x, c.y, c.z}), least = std::min({c.x, c.y, c.z});
    return (most - least) / most;
  };
  const double day = 1000.0, moonlight = 0.01;  // cd/m^2
  EXPECT_NEAR(blue_over_red(day), 1.0, 0.1);
  EXPECT_GT(blue_over_red(moonlight), 2.0);
  EXPECT_LT(saturation(red, moonlight), 0.8 * saturation(red, day));
  EXPECT_LT(saturation(blue, moonlight), 0.95 * saturation(blue, day));
}

TEST(NightSight, IsBelowHalfAStepByDay) {
  // At the exposure up to which it is left out, shown four times as bright; where all light has one
  // primary the change of colour is greatest.
  double most = 0.0;
  for (double luminance = 1e-3; luminance < 4.0; luminance *= 1.1) {
    for (const vec3 tint : {vec3(1), vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1), vec3(1, 1, 0)}) {
      const vec3 c = tint * (4.0 * kFirstNight * luminance / colour_luminance(tint));
      const vec3 day = tonemap_filmic(c),
                 night = tonemap_filmic(night_sight(c, rod_share(luminance)));
      for (int k = 0; k < 3; ++k) {
        most =
            std::max(most, 255.0 * std::abs(srgb_from_linear(day[k]) - srgb_from_linear(night[k])));
      }
    }
  }
  EXPECT_LT(most, 0.5);
  EXPECT_GT(most, 0.05);  // else it could begin later
}

TEST(Dither, IsEvenAndWithinHalfAStep) {
  double sum = 0.0, sum2 = 0.0;
  constexpr int kSide = 256;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const double n = 255.0 * dither(vec2(x + 0.5, y + 0.5));
      EXPECT_LE(std::abs(n), 0.5);
      sum += n;
      sum2 += n * n;
    }
  }
  EXPECT_NEAR(sum / (kSide * kSide), 0.0, 0.002);
  EXPECT_NEAR(sum2 / (kSide * kSide), 1.0 / 12.0, 0.002);  // of an even spread over one step
}

}  // namespace
}  // namespace offing
