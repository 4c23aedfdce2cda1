#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "engine/core/angles.h"

#define OFFING_GLSL "shaders/lib/phase.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/night.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {
using namespace glsl;

TEST(Twinkle, HasMeanOneAndIsSteadyOverhead) {
  for (double seed : {0.1, 0.5, 0.93}) {
    for (double mass : {1.0, 3.0, 30.0}) {
      double sum = 0.0, squares = 0.0;
      constexpr int kSamples = 200000;
      for (int i = 0; i < kSamples; ++i) {
        const double f = twinkle(4096.0 * (i + 0.5) / kSamples, seed, mass, 0.0);
        EXPECT_GE(f, 0.0);
        sum += f;
        squares += (f - 1.0) * (f - 1.0);
      }
      EXPECT_NEAR(sum / kSamples, 1.0, 1e-3);
      const double deviation = std::sqrt(squares / kSamples);
      if (mass == 1.0) {
        EXPECT_LT(deviation, 0.03);
      }
      if (mass == 30.0) {
        EXPECT_GT(deviation, 0.15);
      }
    }
    // The clock of the shaders starts anew after 4096 s.
    EXPECT_NEAR(twinkle(4096.0 - 1e-9, seed, 5.0, 0.1), twinkle(0.0, seed, 5.0, 0.1), 1e-4);
  }
}

TEST(AirMass, OneAtTheZenithAndFortyAtTheHorizon) {
  EXPECT_NEAR(air_mass(1.0), 1.0, 1e-4);
  EXPECT_NEAR(air_mass(0.5), 2.0, 0.02);
  EXPECT_NEAR(air_mass(0.0), 40.0, 0.1);
}

TEST(LommelSeeliger, IsTheIntegralOverTheLitDisc) {
  for (double angle : {0.0, 30.0, 84.0, 120.0, 160.0}) {
    const double a = radians(angle);
    // Over the disc: 2 μ0 / (μ0 + μ), as moon.frag shades it, over pi.
    constexpr int kSide = 2000;
    double sum = 0.0;
    for (int i = 0; i < kSide; ++i) {
      for (int j = 0; j < kSide; ++j) {
        const double x = 2.0 * (i + 0.5) / kSide - 1.0, y = 2.0 * (j + 0.5) / kSide - 1.0;
        if (x * x + y * y >= 1.0) continue;
        const double z = std::sqrt(1.0 - x * x - y * y);
        const double lit = std::max(x * std::sin(a) + z * std::cos(a), 0.0);
        sum += 2.0 * lit / (lit + z + 1e-12);
      }
    }
    sum *= 4.0 / (kSide * kSide) / kPi;
    EXPECT_NEAR(lommel_seeliger_phase(a), sum, 2e-3) << angle;
  }
}

TEST(EarthShadow, LeavesTheSunOutsideAndCopperWithin) {
  const double umbra = 2.65, penumbra = 4.7;
  EXPECT_NEAR(earth_shadow(penumbra, umbra, penumbra).y, 1.0, 1e-12);
  EXPECT_NEAR(earth_shadow(9.0, umbra, penumbra).x, 1.0, 1e-12);
  // Half the sun is left where the earth's limb crosses its middle.
  EXPECT_NEAR(earth_shadow(0.5 * (umbra + penumbra), umbra, penumbra).y, 0.5, 1e-3);
  double last = 2.0;
  for (double d = 6.0; d >= 0.0; d -= 0.01) {
    const vec3 now = earth_shadow(d, umbra, penumbra);
    EXPECT_LE(now.y, last + 1e-12) << d;
    EXPECT_GT(now.z, 0.0);
    last = now.y;
  }
  const vec3 middle = earth_shadow(0.0, umbra, penumbra);
  EXPECT_GT(middle.x, 3.0 * middle.z);
  EXPECT_LT(middle.y, 1e-4);
}

TEST(Corona, FallsAndGivesAboutHalfAFullMoon) {
  // Its light over the sun's: 0.6e-6 to 1.3e-6 (Allen, §78), a full moon's is 2.2e-6.
  double sum = 0.0, last = 1.0;
  constexpr double kStep = 0.001;
  for (double r = 1.0 + 0.5 * kStep; r < 10.0; r += kStep) {
    EXPECT_LT(corona(r), last);
    last = corona(r);
    sum += 2.0 * r * kStep * last;
  }
  EXPECT_GT(sum, 0.5e-6);
  EXPECT_LT(sum, 2.0e-6);
}

TEST(Moonlight, HasLuminanceOne) {
  EXPECT_NEAR(dot(moon_colour(), vec3(0.2126, 0.7152, 0.0722)), 1.0, 1e-4);
}

}  // namespace
}  // namespace offing
