// Light in the sea against closed forms and published values.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/angles.h"

#define OFFING_GLSL "shaders/lib/phase.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/water.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/underwater.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {
using glm::dvec2;
using glm::dvec3;

TEST(Underwater, TheWindowEndsAtTheCriticalAngle) {
  const double critical = std::asin(1.0 / 1.34);
  EXPECT_NEAR(degrees(critical), 48.27, 0.01);
  EXPECT_EQ(glsl::fresnel_from_below(std::cos(critical + 1e-6)), 1.0);
  EXPECT_LT(glsl::fresnel_from_below(std::cos(critical - 1e-3)), 0.85);
  const double straight = 0.34 / 2.34;
  EXPECT_NEAR(glsl::fresnel_from_below(1.0), straight * straight, 1e-12);
}

// Both directions of one ray lose the same (Stokes).
TEST(Underwater, TheSurfaceReflectsAlikeFromBothSides) {
  for (const double angle : {5.0, 30.0, 60.0, 85.0}) {
    const double above = radians(angle);
    const double below = std::asin(std::sin(above) / 1.34);
    // Fresnel's own form, by sines and tangents of the two angles.
    const double s = std::sin(above - below) / std::sin(above + below);
    const double p = std::tan(above - below) / std::tan(above + below);
    EXPECT_NEAR(glsl::fresnel_from_below(std::cos(below)), 0.5 * (s * s + p * p), 1e-9) << angle;
  }
}

// Light that falls evenly from all of the sky goes through or back, and all of it that goes through
// comes within the window: the mean of the transmittance agrees on both sides.
TEST(Underwater, AnEvenSkyLosesSixPercent) {
  double above = 0.0, below = 0.0;
  constexpr int kSteps = 20000;
  for (int i = 0; i < kSteps; ++i) {
    const double c = (i + 0.5) / kSteps;
    above += 2.0 * c * (1.0 - glsl::fresnel_water(c)) / kSteps;
    below += 2.0 * c * (1.0 - glsl::fresnel_from_below(c)) / kSteps;
  }
  EXPECT_NEAR(1.0 - above, 0.066, 0.003);  // Preisendorfer & Mobley 1986
  EXPECT_NEAR(below * 1.34 * 1.34, above, 1e-4);
}

// The integral over a way against many small steps, and the ends that it must meet.
TEST(Underwater, LightOnTheWayIsItsIntegral) {
  for (const double k : {-0.05, 1e-7, 0.02, 0.7}) {
    for (const double s : {0.01, 3.0, 60.0}) {
      constexpr int kSteps = 20000;
      double sum = 0.0;
      for (int i = 0; i < kSteps; ++i) sum += std::exp(-k * s * (i + 0.5) / kSteps) * s / kSteps;
      EXPECT_NEAR(glsl::path_integral(dvec3(k), s).x / sum, 1.0, 1e-6) << k << " " << s;
    }
  }
}

// Clear and green water as measured: Kd at 550 nm is .065 to .075 in the clearest (Smith & Baker
// 1981, Morel & Maritorena 2001) and about .11 at .5 mg/m^3; a white disc is lost at 45 to 60 m and
// some 20 m (Morel et al. 2007).
TEST(Underwater, WaterIsAsClearAsMeasured) {
  const glsl::WaterOptics clear = glsl::water_optics(0.02);
  const glsl::WaterOptics middle = glsl::water_optics(0.5);
  EXPECT_NEAR(glsl::diffuse_attenuation(clear, glsl::kDiffuseWay).y, 0.070, 0.010);
  EXPECT_NEAR(glsl::diffuse_attenuation(middle, glsl::kDiffuseWay).y, 0.105, 0.020);
  EXPECT_NEAR(glsl::secchi_depth(clear), 52.0, 8.0);
  EXPECT_NEAR(glsl::secchi_depth(middle), 20.0, 4.0);
  // Blue oceans, green coasts: what is left far down.
  EXPECT_LT(glsl::diffuse_attenuation(clear, 1.2).z, glsl::diffuse_attenuation(clear, 1.2).y);
  const glsl::WaterOptics green = glsl::water_optics(10.0);
  EXPECT_LT(glsl::diffuse_attenuation(green, 1.2).y, glsl::diffuse_attenuation(green, 1.2).z);
}

TEST(Underwater, ClearerWaterHasADeeperDisc) {
  double before = 1e9;
  for (double chlorophyll = 0.01; chlorophyll < 30.0; chlorophyll *= 1.3) {
    const glsl::WaterOptics water = glsl::water_optics(chlorophyll);
    EXPECT_LT(glsl::secchi_depth(water), before);
    before = glsl::secchi_depth(water);
    for (int c = 0; c < 3; ++c) EXPECT_LT(water.backscatter[c], 0.51 * water.scattering[c]);
  }
}

TEST(Underwater, ALightBendsBySnell) {
  const double angle = radians(62.0);
  const glsl::BentLight bent = glsl::bent_light(dvec3(std::sin(angle), std::cos(angle), 0.0));
  EXPECT_NEAR(bent.toward.x, std::sin(angle) / 1.34, 1e-12);
  EXPECT_NEAR(glm::length(bent.toward), 1.0, 1e-12);
  // The same power on a level plane above and below.
  EXPECT_NEAR(bent.passing * bent.toward.y,
              std::cos(angle) * (1.0 - glsl::fresnel_water(std::cos(angle))), 1e-12);
}

// Seen from the water through a sea of small normal slopes, all of a light's power must arrive: the
// integral of radiance times cosine over the directions below.
TEST(Underwater, GlitterFromBelowKeepsThePower) {
  const double angle = radians(40.0);
  const dvec3 toward(std::sin(angle), std::cos(angle), 0.0);
  const dvec3 middle = glsl::bent_light(toward).toward;
  constexpr double kVariance = 2e-4;
  constexpr int kSteps = 400;
  constexpr double kReach = 0.03;  // of the direction's horizontal part
  double power = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const double x = -middle.x + kReach * (2.0 * (i + 0.5) / kSteps - 1.0);
      const double z = -middle.z + kReach * (2.0 * (j + 0.5) / kSteps - 1.0);
      const double y = -std::sqrt(1.0 - x * x - z * z);
      const glsl::BentGlitter g = glsl::bent_glitter(dvec3(x, y, z), toward);
      // Solid angle times cosine is dx dz.
      power += g.radiance * glsl::slope_density(g.slope, kVariance, kVariance, 0.0);
    }
  }
  power *= 4.0 * kReach * kReach / (kSteps * kSteps);
  EXPECT_NEAR(power / (toward.y * (1.0 - glsl::fresnel_water(toward.y))), 1.0, 0.01);
}

TEST(Underwater, LevelWaterSendsPhotonsStraightOn) {
  const dvec3 toward = glm::normalize(dvec3(0.5, 0.7, -0.3));
  const glsl::Photon level = glsl::photon(toward, dvec2(0.0), 1.0);
  const dvec3 bent = glsl::bent_light(toward).toward;
  EXPECT_NEAR(level.carried, 1.0, 1e-12);
  EXPECT_NEAR(level.way.x, -bent.x / bent.y, 1e-12);
  EXPECT_NEAR(level.way.y, -bent.z / bent.y, 1e-12);
}

// Over a long-crested wave what falls on it is what falls on the level sea, less what steeper
// facets reflect; and its crest is a lens with the paraxial focus R / (1 - 1/n).
TEST(Underwater, AWaveIsALens) {
  constexpr double kLength = 2.0, kHeight = 0.01;  // m
  const double k = kTau / kLength;
  double sum = 0.0;
  constexpr int kSteps = 2000;
  for (int i = 0; i < kSteps; ++i) {
    const double slope = -kHeight * k * std::sin(kTau * (i + 0.5) / kSteps);
    sum += glsl::photon(glm::normalize(dvec3(0.3, 1.0, 0.1)), dvec2(slope, 0.0), 1.0).carried;
  }
  EXPECT_NEAR(sum / kSteps, 1.0, 1e-3);
  // Next to the crest the slope is -x / R.
  const double radius = 1.0 / (kHeight * k * k);
  const double focus = radius * 1.34 / 0.34;
  const double x = 1e-3;
  const glsl::Photon p = glsl::photon(dvec3(0.0, 1.0, 0.0), dvec2(-x / radius, 0.0), 1.0);
  EXPECT_NEAR((x + p.way.x * focus) / x, 0.0, 1e-3);
}

// Share of the light that Petzold's mean of measured particles turns by less than an angle (Mobley
// et al., Appl. Opt. 32, 1993).
TEST(Underwater, ScatteringIsThatOfSeaWater) {
  struct Within {
    double degrees, share;
  };
  constexpr Within kMeasured[] = {{10, 0.66557}, {15, 0.75499}, {20, 0.81252}, {25, 0.85241},
                                  {30, 0.88120}, {40, 0.91900}, {50, 0.94304}, {60, 0.95853},
                                  {75, 0.97304}, {90, 0.98191}};
  for (std::size_t i = 0; i + 1 < std::size(kMeasured); ++i) {
    const double from = radians(kMeasured[i].degrees), to = radians(kMeasured[i + 1].degrees);
    constexpr int kSteps = 400;
    double sum = 0.0;
    for (int step = 0; step < kSteps; ++step) {
      const double angle = from + (to - from) * (step + 0.5) / kSteps;
      sum += glsl::sea_water_phase(std::cos(angle)) * kTau * std::sin(angle) * (to - from) / kSteps;
    }
    EXPECT_NEAR(sum / (kMeasured[i + 1].share - kMeasured[i].share), 1.0, 0.06)
        << kMeasured[i].degrees;
  }
}

}  // namespace
}  // namespace offing
