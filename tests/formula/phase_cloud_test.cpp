#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engine/core/angles.h"
#include "support/mie.h"

#define OFFING_GLSL "shaders/lib/phase.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/phase_cloud.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {
using namespace glsl;

/// Integral over the sphere of f(cosine), and of cosine × f; fine where a peak stands straight on.
template <class F>
glm::dvec2 over_sphere(F f) {
  constexpr int kSteps = 40000;
  glm::dvec2 sum(0.0);
  for (int i = 0; i < kSteps; ++i) {
    const double u = (i + 0.5) / kSteps, angle = kPi * u * u;
    const double c = std::cos(angle);
    sum += glm::dvec2(f(c), c * f(c)) * (kTau * std::sin(angle) * kTau * u / kSteps);
  }
  return sum;
}

TEST(CloudPhase, SimpleOnesIntegrateToOne) {
  for (const double g : {-0.6, 0.0, 0.5, 0.9}) {
    for (const double alpha : {0.0, 1.0, 27.0}) {
      const glm::dvec2 d = over_sphere([&](double c) { return draine(g, alpha, c); });
      EXPECT_NEAR(d.x, 1.0, 1e-4) << g << " " << alpha;
      EXPECT_NEAR(d.y, draine_mean_cosine(g, alpha), 1e-4) << g << " " << alpha;
    }
  }
  EXPECT_NEAR(draine(0.7, 0.0, 0.3), henyey_greenstein(0.7, 0.3), 1e-12);
  EXPECT_NEAR(draine(0.7, 1.0, 0.3), cornette_shanks(0.7, 0.3), 1e-12);

  const glm::dvec2 two =
      over_sphere([](double c) { return dual_henyey_greenstein(0.9, -0.5, 0.2, c); });
  EXPECT_NEAR(two.x, 1.0, 1e-4);
  EXPECT_NEAR(two.y, 0.8 * 0.9 - 0.2 * 0.5, 1e-4);
  const glm::dvec2 lined = over_sphere([](double c) { return silver_lining(0.6, 0.3, 0.08, c); });
  EXPECT_NEAR(lined.x, 1.0, 1e-4);
  EXPECT_NEAR(lined.y, 0.7 * 0.6 + 0.3 * 0.91, 1e-4);
  EXPECT_GT(silver_lining(0.6, 0.3, 0.08, 1.0), 5.0 * henyey_greenstein(0.6, 1.0));
}

TEST(CloudPhase, DropletsHaveTheMeanCosineOfTheirFit) {
  const double known[][2] = {{5.0, 0.8434}, {10.0, 0.8642}, {20.0, 0.8793}, {50.0, 0.8912}};
  for (const auto& [diameter, mean] : known) {
    const DropletPhase p = droplet_phase(diameter);
    const glm::dvec2 r = over_sphere([&](double c) { return droplet_scattering(p, c); });
    EXPECT_NEAR(r.x, 1.0, 1e-3) << diameter;
    EXPECT_NEAR(r.y, mean, 1e-3) << diameter;
    EXPECT_NEAR(droplet_mean_cosine(p), mean, 5e-5) << diameter;
  }
}

TEST(CloudPhase, BowsKeepTheIntegral) {
  for (const double diameter : {5.0, 8.0, 13.0, 20.0, 35.0, 50.0}) {
    for (const double wavelength : {0.45, 0.55, 0.65}) {
      const DropletPhase p = droplet_phase(diameter);
      const DropletBows b = droplet_bows(diameter, wavelength);
      const glm::dvec2 r =
          over_sphere([&](double c) { return droplet_scattering_with_bows(p, b, c); });
      EXPECT_NEAR(r.x, 1.0, 1e-3) << diameter << " " << wavelength;
    }
  }
}

TEST(Mie, GivesKnownEfficiencies) {
  // W. Wiscombe, NCAR TN-140, 1979, table for an index of 1.5.
  EXPECT_NEAR(test::mie_sphere(10.0, {1.5, 0.0}, {}).extinction, 2.881999, 1e-6);
  EXPECT_NEAR(test::mie_sphere(100.0, {1.5, 0.0}, {}).extinction, 2.094388, 1e-6);
  EXPECT_NEAR(test::mie_sphere(10.0, {1.5, 0.0}, {}).mean_cosine, 0.742913, 1e-6);
  // Rayleigh's limit: 8/3 x^4 ((m^2 - 1)/(m^2 + 2))^2.
  const double m = 1.33, k = (m * m - 1.0) / (m * m + 2.0);
  EXPECT_NEAR(test::mie_sphere(0.02, {m, 0.0}, {}).scattering,
              8.0 / 3.0 * std::pow(0.02, 4) * k * k, 1e-10);
}

TEST(CloudPhase, FogBowAndGloryStandWhereMiePutsThem) {
  // Degrees from 95 to 180, in quarters.
  std::vector<double> angles, cosines;
  for (int i = 0; i <= 340; ++i) {
    angles.push_back(95.0 + 0.25 * i);
    cosines.push_back(std::cos(radians(angles.back())));
  }
  for (const double diameter : {8.0, 14.0, 20.0, 40.0}) {
    const test::MieSphere mie = test::mie_cloud(diameter, 0.1, 550.0, cosines, 48);
    const DropletPhase p = droplet_phase(diameter);
    const DropletBows b = droplet_bows(diameter, 0.55);
    double plain_error = 0.0, error = 0.0, brightest = 0.0, brightest_mie = 0.0;
    double bow = 0.0, bow_mie = 0.0;
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const double ours = droplet_scattering_with_bows(p, b, cosines[i]);
      plain_error += std::pow(std::log(droplet_scattering(p, cosines[i]) / mie.phase[i]), 2);
      error += std::pow(std::log(ours / mie.phase[i]), 2);
      if (angles[i] < 130.0 || angles[i] > 160.0) continue;
      if (ours > brightest) bow = angles[i];
      if (mie.phase[i] > brightest_mie) bow_mie = angles[i];
      brightest = std::max(brightest, ours);
      brightest_mie = std::max(brightest_mie, mie.phase[i]);
    }
    EXPECT_NEAR(bow, bow_mie, 3.0) << diameter;
    EXPECT_NEAR(brightest / brightest_mie, 1.0, 0.35) << diameter;
    EXPECT_LT(error, 0.75 * plain_error) << diameter;
    // The glory: straight back is brighter than 10 degrees off by as much as there.
    const auto ours = [&](double degrees) {
      return droplet_scattering_with_bows(p, b, std::cos(radians(degrees)));
    };
    const double rise = ours(180.0) / ours(168.0);
    const double rise_mie = mie.phase[340] / mie.phase[292];
    EXPECT_GT(rise, 2.0) << diameter;
    EXPECT_NEAR(std::log(rise / rise_mie), 0.0, 0.9) << diameter;
    RecordProperty("rms_log_" + std::to_string(static_cast<int>(diameter)),
                   std::to_string(std::sqrt(error / 341.0)) + " plain " +
                       std::to_string(std::sqrt(plain_error / 341.0)));
  }
}

}  // namespace
}  // namespace offing
