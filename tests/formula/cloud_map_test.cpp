#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#define OFFING_GLSL "shaders/lib/cloud_map.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

TEST(CloudMapPlaces, DirectionsComeBack) {
  for (double u = 0.02; u < 1.0; u += 0.08) {
    for (double v = 0.02; v < 1.0; v += 0.08) {
      const glm::dvec3 direction = glsl::cloud_map_direction({u, v});
      EXPECT_NEAR(glm::length(direction), 1.0, 1e-12);
      EXPECT_GE(direction.y, 0.0);
      const glm::dvec2 back = glsl::cloud_map_units(direction);
      EXPECT_NEAR(back.x, u, 1e-12);
      EXPECT_NEAR(back.y, v, 1e-12);
    }
  }
}

TEST(CloudMapPlaces, TheZenithIsInTheMiddleAndTheHorizonAllRoundTheEdge) {
  const glm::dvec2 zenith = glsl::cloud_map_units({0.0, 1.0, 0.0});
  EXPECT_NEAR(zenith.x, 0.5, 1e-12);
  EXPECT_NEAR(zenith.y, 0.5, 1e-12);
  for (double t = 0.0; t < 1.0; t += 0.05) {
    EXPECT_NEAR(glsl::cloud_map_direction({t, 0.0}).y, 0.0, 1e-12);
    EXPECT_NEAR(glsl::cloud_map_direction({1.0, t}).y, 0.0, 1e-12);
  }
}

}  // namespace
}  // namespace offing
