#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#define OFFING_GLSL "shaders/lib/noise.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/cloud_noise.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/clouds.glsl"
#include "engine/core/glsl_double.h"

namespace offing::glsl {
namespace {

constexpr double kCurvature = 1.0 / (2.0 * 6.36e6);

TEST(CloudShell, EndsWhereTheHeightsAre) {
  // Against a search along the ray that shares no formula with it, over a true sphere.
  const double radius = 6.36e6, low = 600.0, high = 2400.0;
  for (const double height : {2.0, 300.0, 900.0, 2000.0, 3500.0, 9000.0}) {
    for (const double degrees : {-80.0, -12.0, -1.3, -0.4, 0.0, 0.7, 6.0, 35.0, 90.0}) {
      const double y = std::sin(degrees * 3.14159265358979 / 180.0);
      const CloudSpan span = cloud_shell(height, y, kCurvature, low, high);
      double near = -1.0, far = -1.0;
      for (double t = 0.0; t < 2.2e5; t += 10.0) {
        const double h = std::sqrt(radius * radius + 2.0 * radius * height + height * height +
                                   2.0 * (radius + height) * t * y + t * t) -
                         radius;
        if (h < 0.0) break;
        const bool inside = h > low && h < high;
        if (inside && near < 0.0) near = t;
        if (inside) far = t;
        if (near >= 0.0 && !inside) break;
      }
      if (near < 0.0) {
        EXPECT_LE(span.far, span.near) << height << " " << degrees;
        continue;
      }
      if (far > 2.0e5) continue;
      EXPECT_NEAR(span.near, near, 25.0 + 0.01 * near) << height << " " << degrees;
      EXPECT_NEAR(span.far, far, 25.0 + 0.01 * far) << height << " " << degrees;
    }
  }
}

TEST(CloudBox, HasNoWeakDirections) {
  // Along an axis, nearly along it and askew: as long as the way through really is.
  const vec3 low(-100.0, 500.0, -200.0), high(100.0, 900.0, 200.0);
  const vec3 inside(10.0, 600.0, 20.0);
  EXPECT_NEAR(cloud_box(inside, vec3(0, 1, 0), low, high).far, 300.0, 1e-3);
  EXPECT_NEAR(cloud_box(inside, vec3(0, -1, 0), low, high).far, 100.0, 1e-3);
  EXPECT_NEAR(cloud_box(inside, vec3(1, 0, 0), low, high).far, 90.0, 1e-3);
  EXPECT_NEAR(cloud_box(inside, vec3(0, 0, -1), low, high).far, 220.0, 1e-3);
  EXPECT_NEAR(cloud_box(inside, vec3(1e-9, 1, -1e-12), low, high).far, 300.0, 1e-3);
  const CloudSpan beside = cloud_box(vec3(300.0, 0.0, 0.0), vec3(0, 1, 0), low, high);
  EXPECT_LT(beside.far, beside.near);
  const CloudSpan below = cloud_box(vec3(0.0, 0.0, 0.0), normalize(vec3(0.1, 1.0, 0.0)), low, high);
  EXPECT_NEAR(below.far - below.near, 400.0 * std::sqrt(1.01), 1e-6);
}

TEST(CloudStep, HoldsWhatLiesBetweenItsEnds) {
  // The mean of a clamped ramp, against a sum; any width, both ends on any side.
  for (const double a : {-0.8, -0.05, 0.0, 0.02, 0.1, 0.5}) {
    for (const double b : {-0.6, 0.0, 0.03, 0.13, 0.9}) {
      double sum = 0.0;
      constexpr int kSamples = 20000;
      for (int i = 0; i < kSamples; ++i) {
        const double f = a + (b - a) * (i + 0.5) / kSamples;
        sum += std::clamp(f / kCloudEdgeWidth, 0.0, 1.0) / kSamples;
      }
      EXPECT_NEAR(cloud_mean_ramp(a, b, kCloudEdgeWidth), sum, 1e-6) << a << " " << b;
    }
  }
}

TEST(CloudStep, ASlabIsExactForAnyNumberOfSteps) {
  // Extinction .05 /m, 100 m: transmittance .006738 and the light of an even source, as the march
  // adds them up.
  for (const int steps : {1, 7, 64}) {
    double transmittance = 1.0, light = 0.0;
    for (int i = 0; i < steps; ++i) {
      const double depth = 0.05 * 100.0 / steps * cloud_mean_ramp(0.5, 0.5, kCloudEdgeWidth);
      light += transmittance * (1.0 - std::exp(-depth));
      transmittance *= std::exp(-depth);
    }
    EXPECT_NEAR(transmittance, std::exp(-5.0), 1e-12);
    EXPECT_NEAR(light, 1.0 - std::exp(-5.0), 1e-12);
  }
}

TEST(Weather, CoverageIsAShareOfTheSky) {
  // Of independent, evenly distributed patterns: the share over 1 - cover is the cover.
  for (const double type : {0.0, 0.2, 0.5, 0.8, 1.0}) {
    for (const double cover : {0.05, 0.2, 0.35, 0.5, 0.8, 0.95}) {
      int covered = 0;
      constexpr int kSide = 20;
      for (int i = 0; i < kSide * kSide * kSide * kSide; ++i) {
        const vec4 at(i % kSide, i / kSide % kSide, i / (kSide * kSide) % kSide,
                      i / (kSide * kSide * kSide));
        const double c = weather_coverage((at + vec4(0.5)) / vec4(kSide), cover, type);
        covered += c > 1.0 - cover ? 1 : 0;
      }
      EXPECT_NEAR(static_cast<double>(covered) / std::pow(kSide, 4), cover, 0.04)
          << cover << " " << type;
    }
  }
}

TEST(CloudKinds, StayFiniteAndCloseAtTheirEnds) {
  for (double type = 0.0; type <= 1.0; type += 0.1) {
    const CloudKind kind = cloud_kind(type);
    EXPECT_GT(kind.thickness, 100.0);
    EXPECT_GT(kind.extinction, 0.3);
    // Deep inside its plan there is cloud half way up, none below the base and none over the top,
    // even with the most that noise can add.
    const double strength = cloud_strength(kind, 1.0);
    const double most = 0.5 * kind.roughness;
    EXPECT_GT(strength - cloud_outline(kind, 0.35), 0.0) << type;
    EXPECT_LT(strength + most * cloud_freedom(-0.2) - cloud_outline(kind, -0.2), 0.0) << type;
    EXPECT_LT(strength + most - cloud_outline(kind, 2.2), 0.0) << type;
  }
}

TEST(Storms, StandWhereItRainsHardestAndCloseAtTheirEnds) {
  EXPECT_EQ(storm_thickness(1.0, 0.0), 0.0);
  EXPECT_EQ(storm_thickness(0.0, 1.0), 0.0);
  for (const double rain : {0.05, 0.3, 1.0}) {
    const double thickness = storm_thickness(1.0, rain);
    EXPECT_GT(thickness, cloud_kind(1.0).thickness) << rain;
    const CloudKind kind = storm_kind(thickness, rain);
    const double strength = storm_strength(kind, rain, 0.5, 1.0);
    const double most = storm_strength(kind, rain, 1.0, 1.0) + 0.5 * kind.roughness;
    EXPECT_EQ(storm_strength(kind, 0.0, 1.0, 1.0), 0.0);
    for (double x = 0.02; x < 0.92; x += 0.05) {
      EXPECT_GT(strength, storm_outline(kind, x)) << rain << " " << x;  // from base to top
      EXPECT_GT(storm_outline(kind, x), 0.0) << x;                      // none without rain
    }
    EXPECT_LT(most, storm_outline(kind, -0.02)) << rain;
    EXPECT_LT(most, storm_outline(kind, 1.06)) << rain;
  }
}

TEST(Storms, AnvilsSpreadFromTallTowersAlone) {
  const CloudKind tall = storm_kind(storm_thickness(1.0, 0.8), 0.8);
  const CloudKind low = storm_kind(storm_thickness(1.0, 0.1), 0.1);
  EXPECT_LT(storm_outline(tall, 0.88), 0.3 * storm_outline(tall, 0.6));
  EXPECT_GE(storm_outline(low, 0.88), storm_outline(low, 0.6));
}

TEST(Storms, AreDrawnAlongAsFastAsAMarchExpects) {
  // What skips empty cells bounds the way that a height draws by kMostDrawn.
  const double thickness = 7000.0, lean = 0.3, step = 1.0;
  double fastest = 0.0;
  for (double over = -200.0; over < 1.06 * thickness + 200.0; over += step) {
    const double drawn =
        storm_drawn(over + step, lean, thickness) - storm_drawn(over, lean, thickness);
    EXPECT_GE(drawn, lean * step * (1.0 - 1e-9)) << over;
    fastest = std::max(fastest, drawn / (lean * step));
  }
  EXPECT_LE(fastest, kMostDrawn);
  EXPECT_GT(fastest, 4.0);                                         // an anvil trails
  EXPECT_EQ(storm_drawn(1000.0, lean, thickness), lean * 1000.0);  // other clouds as ever
}

TEST(Storms, RainFallsFromHeapsBeneathTowersAlone) {
  const double precipitation = 0.8, thickness = storm_thickness(1.0, precipitation);
  const CloudKind kind = storm_kind(thickness, precipitation);
  for (double rain = 0.0; rain <= precipitation; rain += 0.02) {
    EXPECT_EQ(rain_falling(0.0, precipitation, rain), rain);
    const double falls = rain_falling(1.0, precipitation, rain);
    EXPECT_LE(falls, rain);
    const double strength = storm_strength(kind, rain, 1.0, cloud_freedom(0.1));
    if (falls > 0.0) {
      EXPECT_GT(strength, storm_outline(kind, 0.02)) << rain;
    }
  }
  EXPECT_EQ(rain_falling(1.0, precipitation, precipitation), precipitation);
}

TEST(Weather, AClosedSkyHasNoThinPlaces) {
  for (const double cover : {0.0, 0.3, 0.8}) EXPECT_EQ(weather_threshold(cover), 1.0 - cover);
  EXPECT_LT(weather_threshold(1.0), -0.2);
  for (double cover = 0.0; cover < 1.0; cover += 0.05) {
    EXPECT_LT(weather_threshold(cover + 0.05), weather_threshold(cover));
  }
}

TEST(Weather, ShowersCoverAShareAndLayersRainFromThemselves) {
  int raining = 0, stray = 0;
  constexpr int kSide = 60;
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      const double fronts = (i + 0.5) / kSide, other = (j + 0.5) / kSide;
      raining += weather_rain(0.0, fronts, other, 0.6, 1.0, 0.8) > 0.0 ? 1 : 0;
      stray += other < 0.4 && weather_rain(other, fronts, 0.5, 0.6, 0.0, 1.0) > 0.0 ? 1 : 0;
      const double rain = weather_rain(other, fronts, other, 0.6, 1.0, 0.8);
      ASSERT_GE(rain, 0.0);
      ASSERT_LE(rain, 0.8);
    }
  }
  EXPECT_NEAR(static_cast<double>(raining) / (kSide * kSide), 0.3 * 0.8, 0.04);
  EXPECT_EQ(stray, 0);  // no rain from a layer where there is none
}

TEST(CloudNoise, RepeatsAndFillsItsRange) {
  const NoiseChannel channel{5, 3, 0.5, 2, 1.0};
  double least = 1.0, most = 0.0;
  for (int i = 0; i < 600; ++i) {
    const vec3 at(std::fmod(0.317 * i, 1.0), std::fmod(0.173 * i, 1.0), std::fmod(0.619 * i, 1.0));
    for (int axis = 0; axis < 3; ++axis) {
      vec3 next = at;
      next[axis] += 1.0;
      EXPECT_NEAR(cellular_octaves(channel, at, 128, 1), cellular_octaves(channel, next, 128, 1),
                  1e-9);
      EXPECT_NEAR(gradient_octaves(channel, at, 128, 1), gradient_octaves(channel, next, 128, 1),
                  1e-9);
    }
    least = std::min(least, cellular_octaves(channel, at, 128, 1));
    most = std::max(most, cellular_octaves(channel, at, 128, 1));
  }
  EXPECT_GE(least, 0.0);
  EXPECT_LE(most, 1.0);
  EXPECT_GT(most - least, 0.4);
}

TEST(CloudNoise, DropsCellsFinerThanTwoTexels) {
  // With 16 texels a side the octave of 16 cells may not be there.
  const vec3 at(0.21, 0.43, 0.65);
  EXPECT_EQ(cellular_octaves({8, 2, 0.5, 2, 0.0}, at, 16, 3),
            cellular_octaves({8, 1, 0.5, 2, 0.0}, at, 16, 3));
  EXPECT_NE(cellular_octaves({8, 2, 0.5, 2, 0.0}, at, 32, 3),
            cellular_octaves({8, 1, 0.5, 2, 0.0}, at, 32, 3));
}

}  // namespace
}  // namespace offing::glsl
