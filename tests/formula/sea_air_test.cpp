#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/angles.h"

#define OFFING_GLSL "shaders/ocean/air.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

// All the way round: a heading's place gives the heading back, places run from 0 to 1 once, and no
// step of a degree is more than twice its share of the strip.
TEST(SeaAir, HeadingsHaveOnePlaceEach) {
  double before = glsl::horizon_place({1.0, 0.0});
  for (int degree = 1; degree <= 360; ++degree) {
    const glm::dvec2 heading(std::cos(radians(degree)), std::sin(radians(degree)));
    const double place = glsl::horizon_place(3.0 * heading);
    EXPECT_GE(place, 0.0);
    EXPECT_LE(place, 1.0);
    const glm::dvec2 again = glm::normalize(glsl::horizon_heading(place));
    EXPECT_NEAR(glm::length(again - heading), 0.0, 1e-12) << degree;
    const double step = place - before - std::round(place - before);
    EXPECT_GT(step, 0.5 / 360.0) << degree;
    EXPECT_LT(step, 2.0 / 360.0) << degree;
    before = place;
  }
}

}  // namespace
}  // namespace offing
