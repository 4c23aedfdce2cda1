#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "engine/core/random.h"

#define OFFING_GLSL "shaders/lib/noise.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {
using glm::dvec3;

dvec3 random_point(std::uint64_t index, double range) {
  return range * (dvec3(random_uniform(7, 0, index), random_uniform(7, 1, index),
                        random_uniform(7, 2, index)) -
                  0.5);
}

TEST(Noise, IsZeroAtLatticePointsWithTheCornersOwnGradient) {
  dvec3 mean(0.0);
  constexpr int kHalf = 8;
  for (int x = -kHalf; x < kHalf; ++x) {
    for (int y = -kHalf; y < kHalf; ++y) {
      for (int z = -kHalf; z < kHalf; ++z) {
        const glsl::Noise noise = glsl::gradient_noise(dvec3(x, y, z));
        EXPECT_EQ(noise.value, 0.0);
        EXPECT_EQ(noise.gradient, glsl::noise_lattice_gradient(x, y, z));
        mean += noise.gradient;
      }
    }
  }
  // 4096 gradients whose components have a variance of 2/3: five standard deviations of the mean.
  mean /= 4096.0;
  const double limit = 5.0 * std::sqrt(2.0 / 3.0 / 4096.0);
  EXPECT_LT(std::abs(mean.x), limit);
  EXPECT_LT(std::abs(mean.y), limit);
  EXPECT_LT(std::abs(mean.z), limit);
}

TEST(Noise, GradientsAreTheTwelveEdgesOfACube) {
  std::set<std::tuple<double, double, double>> seen;
  for (int x = 0; x < 400; ++x) {
    const dvec3 g = glsl::noise_lattice_gradient(x, -3 * x, 7 - x);
    EXPECT_EQ(glm::dot(g, g), 2.0);
    seen.insert({g.x, g.y, g.z});
  }
  EXPECT_EQ(seen.size(), 12u);
}

TEST(Noise, GradientIsThatOfTheValue) {
  constexpr double kStep = 1e-5;
  for (std::uint64_t i = 0; i < 500; ++i) {
    const dvec3 p = random_point(i, 40.0);
    const dvec3 gradient = glsl::gradient_noise(p).gradient;
    for (int axis = 0; axis < 3; ++axis) {
      dvec3 step(0.0);
      step[axis] = kStep;
      const double slope =
          (glsl::gradient_noise(p + step).value - glsl::gradient_noise(p - step).value) /
          (2.0 * kStep);
      EXPECT_NEAR(gradient[axis], slope, 1e-7) << "axis " << axis;  // O(step^2) + rounding / step
    }
  }
}

TEST(Noise, ValueAndGradientAreContinuousAcrossCells) {
  constexpr double kStep = 1e-9;
  for (std::uint64_t i = 0; i < 300; ++i) {
    dvec3 p = random_point(i, 20.0);
    const int axis = static_cast<int>(i % 3);
    p[axis] = std::round(p[axis]);
    dvec3 step(0.0);
    step[axis] = kStep;
    const glsl::Noise below = glsl::gradient_noise(p - step);
    const glsl::Noise above = glsl::gradient_noise(p + step);
    EXPECT_NEAR(below.value, above.value, 1e-8);
    // The quintic fade has no second derivative at the corners, so the gradient does not even kink.
    EXPECT_LT(glm::length(below.gradient - above.gradient), 1e-7);
  }
}

TEST(Noise, ValueAndGradientAreBounded) {
  double largest = 0.0, steepest = 0.0, sum = 0.0;
  constexpr std::uint64_t kPoints = 200'000;
  for (std::uint64_t i = 0; i < kPoints; ++i) {
    const glsl::Noise noise = glsl::gradient_noise(random_point(i, 500.0));
    largest = std::max(largest, std::abs(noise.value));
    steepest = std::max(steepest, glm::length(noise.gradient));
    sum += noise.value;
  }
  // A ramp reaches at most sqrt(2) x distance; the blend of eight such keeps below 1.04 for these
  // gradients, and the slope below sqrt(2) + 1.875 x the spread of the ramps (2 sqrt 2).
  EXPECT_LT(largest, 1.04);
  EXPECT_GT(largest, 0.75);
  EXPECT_LT(steepest, std::sqrt(2.0) + 1.875 * 2.0 * std::sqrt(2.0));
  EXPECT_NEAR(sum / static_cast<double>(kPoints), 0.0, 5.0 * 0.3 / std::sqrt(kPoints));
}

}  // namespace
}  // namespace offing
