#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/angles.h"

#define OFFING_GLSL "shaders/lib/ggx.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {
using glm::dvec3;

TEST(Ggx, ProjectedAreaOfTheMicrofacetsIsOne) {
  for (const double alpha : {0.04, 0.15, 0.5, 1.0}) {
    // Over tan(theta) = alpha tan(phi) the integrand is smooth, however narrow the lobe.
    constexpr int kSteps = 4000;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
      const double phi = (i + 0.5) / kSteps * kPi / 2.0;
      const double theta = std::atan(alpha * std::tan(phi));
      const double t = std::tan(phi);
      const double slope = alpha * (1.0 + t * t) / (1.0 + alpha * alpha * t * t);
      sum += glsl::ggx_density(std::cos(theta), alpha) * std::cos(theta) * std::sin(theta) * slope;
    }
    EXPECT_NEAR(sum * (kPi / 2.0 / kSteps) * kTau, 1.0, 1e-5) << "alpha " << alpha;
  }
}

TEST(Ggx, WhiteSurfaceNeverReflectsMoreThanItReceives) {
  for (const double alpha : {0.1, 0.3, 1.0}) {
    for (const double cosine : {0.15, 0.5, 0.95}) {
      const dvec3 v(std::sqrt(1.0 - cosine * cosine), cosine, 0.0);
      constexpr int kRows = 500, kColumns = 500;
      double sum = 0.0;
      for (int i = 0; i < kRows; ++i) {
        const double y = (i + 0.5) / kRows;
        const double r = std::sqrt(1.0 - y * y);
        for (int j = 0; j < kColumns; ++j) {
          const double a = (j + 0.5) / kColumns * kTau;
          const dvec3 l(r * std::cos(a), y, r * std::sin(a));
          const dvec3 h = glm::normalize(l + v);
          sum += y * glsl::ggx_density(h.y, alpha) * glsl::ggx_visibility(y, cosine, alpha);
        }
      }
      sum *= kTau / (kRows * kColumns);
      // One bounce only: what is missing was shadowed.
      EXPECT_LT(sum, 1.0) << alpha << " " << cosine;
      // At alpha 1 the density is constant and the integral is elementary.
      if (alpha == 1.0) {
        EXPECT_NEAR(sum, 1.0 - cosine * std::log((1.0 + cosine) / cosine), 1e-5);
      }
    }
  }
}

TEST(Ggx, FresnelRunsFromTheSurfacesOwnToWhite) {
  const dvec3 f0(0.04, 0.5, 0.9);
  EXPECT_EQ(glsl::schlick_fresnel(f0, 1.0), f0);
  EXPECT_EQ(glsl::schlick_fresnel(f0, 0.0), dvec3(1.0));
}

}  // namespace
}  // namespace offing
