#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "engine/core/angles.h"

#define OFFING_GLSL "shaders/lib/phase.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/scattering.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {
using namespace glsl;

/// Integral over the sphere of f(cosine), and of cosine × f.
template <class F>
glm::dvec2 over_sphere(F f) {
  constexpr int kSteps = 20000;
  glm::dvec2 sum(0.0);
  for (int i = 0; i < kSteps; ++i) {
    const double c = -1.0 + (i + 0.5) * 2.0 / kSteps;
    sum += glm::dvec2(f(c), c * f(c)) * (kTau * 2.0 / kSteps);
  }
  return sum;
}

TEST(Phase, IntegratesToOneWithItsMeanCosine) {
  const glm::dvec2 r = over_sphere([](double c) { return rayleigh_phase(c); });
  EXPECT_NEAR(r.x, 1.0, 1e-6);
  EXPECT_NEAR(r.y, 0.0, 1e-6);
  for (double g : {-0.5, 0.0, 0.3, 0.8, 0.9}) {
    const glm::dvec2 h = over_sphere([&](double c) { return henyey_greenstein(g, c); });
    EXPECT_NEAR(h.x, 1.0, 1e-4) << g;
    EXPECT_NEAR(h.y, g, 1e-4) << g;
    const glm::dvec2 s = over_sphere([&](double c) { return cornette_shanks(g, c); });
    EXPECT_NEAR(s.x, 1.0, 1e-4) << g;
    // Cornette & Shanks 1992, eq. 7.
    EXPECT_NEAR(s.y, g * 3.0 * (4.0 + g * g) / (5.0 * (2.0 + g * g)), 1e-4) << g;
  }
  EXPECT_NEAR(cornette_shanks(0.0, 0.4), rayleigh_phase(0.4), 1e-12);
}

TEST(Transmittance, OfTheClearAirFromTheSea) {
  // Independently integrated with the constants of Hillaire's demo.
  const double known[][4] = {{90.0, 0.94036, 0.86762, 0.76231},
                             {30.0, 0.88478, 0.75386, 0.58228},
                             {10.0, 0.71294, 0.45938, 0.22163},
                             {2.0, 0.33081, 0.08528, 0.00616}};
  for (const auto& [elevation, r, g, b] : known) {
    for (int steps : {48, 2000}) {  // as in the table's shader; converged
      const vec3 t =
          transmittance_to_top(aerosol_of_haze(0.0), 0.0, std::sin(radians(elevation)), steps);
      EXPECT_NEAR(t.x / r, 1.0, 0.003) << elevation << " " << steps;
      EXPECT_NEAR(t.y / g, 1.0, 0.003) << elevation << " " << steps;
      EXPECT_NEAR(t.z / b, 1.0, 0.003) << elevation << " " << steps;
    }
  }
}

TEST(Transmittance, UpAndDownAreOnePath) {
  // From the sea up along a ray to 30 km and on to the top, or from 30 km looking the other way:
  // T(sea, c) = T(sea to 30 km) T(30 km, c'), and looking back down must give the first factor.
  const Aerosol aerosol = aerosol_of_haze(0.3);
  for (double c : {0.02, 0.1, 0.5}) {
    const double r0 = kPlanetRadius, r1 = kPlanetRadius + 30.0;
    const double along = -r0 * c + std::sqrt(r1 * r1 - r0 * r0 * (1.0 - c * c));
    const double there = cosine_along(0.0, c, 1.0, along, 30.0);
    const vec3 whole = transmittance_to_top(aerosol, 0.0, c, 4000);
    const vec3 rest = transmittance_to_top(aerosol, 30.0, there, 4000);
    const vec3 first = exp(-optical_depth_outward(aerosol, 0.0, c, along, 4000));
    EXPECT_NEAR(height_along(0.0, c, along), 30.0, 1e-6);
    EXPECT_NEAR(whole.y / (first.y * rest.y), 1.0, 1e-4);
  }
}

TEST(Transmittance, TheTableCanBeReadAtEveryPlace) {
  for (double h : {0.0, 0.002, 1.0, 20.0, 99.0}) {
    for (double e = 0.0; e <= 1.0; e += 0.1) {
      const double lowest = -horizon_dip_sine(h);
      const double c = lowest + (1.0 - lowest) * e;
      const vec2 units = transmittance_units(h, c);
      const HeightCosine back = transmittance_place(units);
      EXPECT_NEAR(back.height, h, 1e-6 + 1e-9 * h);
      EXPECT_NEAR(back.cosine, c, 2e-5) << h;
    }
  }
  for (double h : {0.0, 3.0, 60.0}) {
    for (double c : {-0.3, -0.05, 0.0, 0.2, 1.0}) {
      const HeightCosine back = multiscatter_place(multiscatter_units(h, c));
      EXPECT_NEAR(back.height, h, 1e-9);
      EXPECT_NEAR(back.cosine, c, 1e-9);
    }
  }
  for (double a : {-1.0, -0.3, 0.9, 1.0}) {
    for (double s : {0.0, 1e-4, 0.3, 1.0}) {
      const SkyViewPlace back = sky_view_place(sky_view_units(a, s));
      EXPECT_NEAR(back.cosine_azimuth, a, 1e-12);
      EXPECT_NEAR(back.sine_above_horizon, s, 1e-12);
    }
  }
}

TEST(Rays, AgreeWithPlainGeometry) {
  for (double h : {0.003, 1.0, 50.0}) {
    for (double c : {-0.9, -0.2, 0.0, 0.4, 1.0}) {
      const double r = kPlanetRadius + h;
      const glm::dvec3 start(0.0, r, 0.0), d(std::sqrt(1.0 - c * c), c, 0.0);
      const double top = distance_to_top(h, c);
      EXPECT_NEAR(glm::length(start + top * d), kPlanetRadius + kAirTop, 1e-8);
      const double sea = distance_to_sea(h, c);
      if (sea >= 0.0) {
        EXPECT_NEAR(glm::length(start + sea * d), kPlanetRadius, 1e-8);
      }
      EXPECT_EQ(sea >= 0.0, c < -horizon_dip_sine(h));
      EXPECT_NEAR(height_along(h, c, 7.0), glm::length(start + 7.0 * d) - kPlanetRadius, 1e-8);
      const glm::dvec3 sun = glm::normalize(glm::dvec3(0.6, 0.5, 0.2)), at = start + 7.0 * d;
      EXPECT_NEAR(cosine_along(h, sun.y, glm::dot(sun, d), 7.0, glm::length(at) - kPlanetRadius),
                  glm::dot(glm::normalize(at), sun), 1e-12);
    }
  }
  // 3 m over the sea the horizon lies 6.2 km away, 3.3 minutes of arc down.
  EXPECT_NEAR(distance_to_sea(0.003, -horizon_dip_sine(0.003) - 1e-9), 6.18, 0.1);
  EXPECT_NEAR(degrees(std::asin(horizon_dip_sine(0.003))) * 60.0, 3.34, 0.01);
}

TEST(Discs, ShareAboveTheHorizon) {
  const double r = radians(0.2667);
  EXPECT_NEAR(share_above_horizon(0.0, 0.0, r), 0.5, 1e-12);
  EXPECT_EQ(share_above_horizon(0.0, std::sin(1.1 * r), r), 1.0);
  EXPECT_EQ(share_above_horizon(0.0, -std::sin(1.1 * r), r), 0.0);
  // Half the radius below: the segment of a circle.
  EXPECT_NEAR(share_above_horizon(0.0, std::sin(-0.5 * r), r),
              (std::acos(0.5) - 0.5 * std::sqrt(0.75)) / kPi, 1e-9);
}

TEST(Discs, LimbDarkeningKeepsTheMean) {
  vec3 sum(0.0);
  constexpr int kSteps = 20000;
  for (int i = 0; i < kSteps; ++i) {
    const double x = (i + 0.5) / kSteps;
    sum += limb_darkening(x) * (2.0 * x / kSteps);
  }
  EXPECT_NEAR(sum.x, 1.0, 1e-4);
  EXPECT_NEAR(sum.y, 1.0, 1e-4);
  EXPECT_NEAR(sum.z, 1.0, 1e-4);
  EXPECT_LT(limb_darkening(0.99).z, limb_darkening(0.99).x);  // the limb is redder
}

TEST(Moonlight, IsNotInProportionToTheLitFraction) {
  EXPECT_EQ(moon_phase_brightness(0.0), 1.0);
  EXPECT_NEAR(moon_phase_brightness(84.0), 0.109, 0.004);  // 55 % lit
  EXPECT_LT(moon_phase_brightness(170.0), 1e-3);
}

TEST(Bands, GreyStaysGreyAndScaleIsKept) {
  const vec3 grey = srgb_from_bands(vec3(0.37));
  EXPECT_NEAR(grey.x, 0.37, 1e-4);
  const vec3 a = srgb_from_bands(vec3(0.2, 0.5, 0.9)), b = srgb_from_bands(vec3(2e-9, 5e-9, 9e-9));
  EXPECT_NEAR(b.x / a.x, 1e-8, 1e-12);
  // Rayleigh's law holds at the red that it reads off: (680 / 628)^4 over the red band.
  const auto rayleigh = [](double nm) { return std::pow(550.0 / nm, 4.0); };
  EXPECT_NEAR(srgb_from_bands(vec3(rayleigh(680), 1.0, rayleigh(440))).x / rayleigh(628), 1.0,
              0.01);
  EXPECT_TRUE(std::isfinite(srgb_from_bands(vec3(0.0)).x));
  EXPECT_LE(srgb_from_bands(vec3(1e-3, 1e-9, 0.0)).x, 1e-3);
}

TEST(Haze, RunsFromClearToFog) {
  EXPECT_NEAR(aerosol_of_haze(0.0).extinction, 0.00444, 1e-12);
  EXPECT_NEAR(aerosol_of_haze(0.0).scattering, 0.003996, 1e-12);
  EXPECT_NEAR(aerosol_of_haze(0.0).scale_height, 1.2, 1e-12);
  EXPECT_NEAR(3.912 / aerosol_of_haze(1.0).extinction, 0.25,
              0.01);  // km of visibility (Koschmieder)
  double last = 0.0;
  for (double haze = 0.0; haze <= 1.0; haze += 0.05) {
    const Aerosol a = aerosol_of_haze(haze);
    EXPECT_GT(a.extinction, last);
    EXPECT_LT(a.scattering, a.extinction);
    last = a.extinction;
  }
}

}  // namespace
}  // namespace offing
