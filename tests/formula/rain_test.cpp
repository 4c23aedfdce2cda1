#include <gtest/gtest.h>

#include <cmath>

#define OFFING_GLSL "shaders/lib/rain.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

TEST(Rain, ExtinctionIsTheIntegralOverMarshallAndPalmersDrops) {
  for (const double rate : {0.5, 1.0, 10.0, 60.0}) {
    const double lambda = 4.1 * std::pow(rate, -0.21);  // 1/mm
    double sum = 0.0;
    constexpr double kStep = 0.002;  // mm
    for (double d = 0.5 * kStep; d < 40.0; d += kStep) {
      const double area = 3.14159265358979 / 4.0 * d * d * 1e-6;  // m^2
      sum += 2.0 * area * 8000.0 * std::exp(-lambda * d) * kStep;
    }
    EXPECT_NEAR(glsl::rain_extinction(rate) / sum, 1.0, 1e-3) << rate;
  }
}

TEST(Rain, VisibilityIsThatOfForecasters) {
  // Koschmieder's 3.912 over the extinction: some 10 km in light rain, 1 to 2 km in a downpour.
  EXPECT_NEAR(3.912 / glsl::rain_extinction(1.0), 10700.0, 500.0);
  const double downpour = 3.912 / glsl::rain_extinction(50.0);
  EXPECT_GT(downpour, 800.0);
  EXPECT_LT(downpour, 2000.0);
  EXPECT_EQ(glsl::rain_extinction(0.0), 0.0);
  EXPECT_EQ(glsl::rain_rate(0.0, 60.0), 0.0);
}

}  // namespace
}  // namespace offing
