#include "engine/sky/sky_light.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <thread>

#include "engine/core/angles.h"
#include "engine/environment/calendar.h"
#include "engine/sky/air_reference.h"
#include "shaders/shared/frame.h"

namespace offing {
namespace {

double luminance(glm::dvec3 c) { return glm::dot(c, glm::dvec3(0.2126, 0.7152, 0.0722)); }

/// Sun and moon put where a test wants them.
CelestialState sky_with(double sun_elevation, double moon_elevation, double phase_angle) {
  CelestialState s;
  s.sun.azimuth_deg = 180.0;
  s.sun.elevation_deg = s.sun.elevation_airless_deg = sun_elevation;
  s.moon.azimuth_deg = 40.0;
  s.moon.elevation_deg = s.moon.elevation_airless_deg = moon_elevation;
  s.moon_phase_angle_deg = phase_angle;
  s.moon_lit_fraction = 0.5 + 0.5 * std::cos(radians(phase_angle));
  return s;
}

TEST(SkyLight, IlluminanceThroughDayAndNight) {
  SkyLightModel model;
  const auto level = [&](double sun, double moon, double phase) {
    return model.update(sky_with(sun, moon, phase), 0.1, 2.0).level_illuminance();
  };
  const double noon = level(65.0, -40.0, 90.0);
  EXPECT_GT(noon, 90e3);
  EXPECT_LT(noon, 120e3);
  const double sunset = level(-0.25, -40.0, 90.0);  // centre on the horizon, seen refracted
  EXPECT_GT(sunset, 300.0);
  EXPECT_LT(sunset, 1000.0);
  const double civil = level(-6.0, -40.0, 90.0);  // end of civil twilight: some 3 lx
  EXPECT_GT(civil, 1.0);
  EXPECT_LT(civil, 10.0);
  const double full_moon = level(-40.0, 60.0, 3.0);
  EXPECT_GT(full_moon, 0.05);
  EXPECT_LT(full_moon, 0.35);
  const double half_moon = level(-40.0, 60.0, 84.0);
  EXPECT_LT(half_moon, 0.15 * full_moon);
  const double stars = level(-40.0, -40.0, 90.0);
  EXPECT_GT(stars, 0.5e-3);
  EXPECT_LT(stars, 2e-3);
}

TEST(SkyLight, FallsSmoothlyAndTheSunStandsWhereItShould) {
  SkyLightModel model;
  double last = 0.0, last_exposure = 0.0;
  for (double e = 20.0; e > -25.0; e -= 0.05) {
    const SkyLight& l = model.update(sky_with(e, -40.0, 90.0), 0.1, 2.0);
    const double now = l.level_illuminance();
    ASSERT_TRUE(std::isfinite(now) && now > 0.0) << e;
    if (last > 0.0) {
      EXPECT_LE(now, last * 1.0001) << e;
      EXPECT_GT(now, last * 0.92) << e;  // late dusk falls by half a decade a degree
      EXPECT_NEAR(l.exposure / last_exposure, 1.0, 0.09) << e;
    }
    last = now;
    last_exposure = l.exposure;
    EXPECT_NEAR(l.sun_direction.y, std::sin(radians(e)), 1e-12);
    EXPECT_NEAR(l.sun_direction.z, std::cos(radians(e)), 1e-12);  // due south is +z
  }
}

TEST(SkyLight, SunsetIsRedAndDuskIsBlue) {
  SkyLightModel model;
  const SkyLight low = model.update(sky_with(1.0, -40.0, 90.0), 0.1, 2.0);
  EXPECT_GT(low.sun_illuminance.x, 2.0 * low.sun_illuminance.y);
  EXPECT_GT(low.sun_illuminance.y, 5.0 * low.sun_illuminance.z);
  const SkyLight dusk = model.update(sky_with(-5.0, -40.0, 90.0), 0.1, 2.0);
  EXPECT_GT(dusk.sky_illuminance.z, 1.5 * dusk.sky_illuminance.y);
  EXPECT_EQ(luminance(dusk.sun_illuminance), 0.0);
}

TEST(SkyLight, HazeTakesFromTheSunAndGivesToTheSky) {
  SkyLightModel model;
  const SkyLight clear = model.update(sky_with(40.0, -40.0, 90.0), 0.0, 2.0);
  const SkyLight hazy = model.update(sky_with(40.0, -40.0, 90.0), 0.5, 2.0);
  EXPECT_LT(luminance(hazy.sun_illuminance), 0.8 * luminance(clear.sun_illuminance));
  EXPECT_GT(luminance(hazy.sky_illuminance), 1.3 * luminance(clear.sky_illuminance));
  EXPECT_LT(hazy.level_illuminance(), clear.level_illuminance());
  EXPECT_GT(hazy.extinction.y, 10.0 * clear.extinction.y);
}

TEST(SkyLight, InTheBackgroundHazeAndItsLightChangeInOneFrame) {
  const CelestialState sky = sky_with(40.0, -40.0, 90.0);
  SkyLightModel at_once, model;
  model.set_in_background(true);
  const SkyLight clear = at_once.update(sky, 0.1, 2.0), fog = at_once.update(sky, 0.9, 2.0);
  model.update(sky, 0.1, 2.0);
  int frames = 0;
  for (SkyLight seen = model.update(sky, 0.9, 2.0); frames < 10000; ++frames) {
    const SkyLight& whole = seen.haze == 0.9 ? fog : clear;
    ASSERT_EQ(seen.haze, whole.haze);
    ASSERT_EQ(seen.extinction, whole.extinction);
    ASSERT_NEAR(seen.sky_illuminance.y / whole.sky_illuminance.y, 1.0, 1e-9);
    ASSERT_NEAR(seen.sun_illuminance.y / whole.sun_illuminance.y, 1.0, 1e-9);
    if (seen.haze == 0.9) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    seen = model.update(sky, 0.9, 2.0);
  }
  EXPECT_LT(frames, 10000);
}

TEST(SkyLight, TheEclipseTakesTheSunAway) {
  // Off A Coruña the moon covers the sun wholly at 18:28 UTC on 2026-08-12.
  SkyLightModel model;
  const auto uncovered = [&](const char* time) {
    const double utc = *parse_date("2026-08-12") + *parse_time(time);
    return model.update(celestial_state(utc, 43.3623, -8.4115), 0.1, 2.0).sun_uncovered;
  };
  EXPECT_EQ(uncovered("16:00"), 1.0);
  EXPECT_LT(uncovered("18:20"), 0.3);
  EXPECT_GT(uncovered("18:20"), 0.01);
  EXPECT_LT(uncovered("18:28"), 2e-6);
  EXPECT_GT(uncovered("18:36"), 0.01);
}

TEST(SkyLight, TotalityIsADeepTwilight) {
  // About as much light as half an hour after sunset, nearly all of it from the air outside the
  // shadow; minutes before and after it is day.
  SkyLightModel model;
  const auto lux = [&](const char* time) {
    const double utc = *parse_date("2026-08-12") + *parse_time(time);
    return model.update(celestial_state(utc, 43.3623, -8.4115), 0.1, 2.0).level_illuminance();
  };
  EXPECT_GT(lux("18:28"), 0.5);
  EXPECT_LT(lux("18:28"), 10.0);
  EXPECT_GT(lux("18:20"), 500.0);
  const double utc = *parse_date("2026-08-12") + *parse_time("18:28");
  const SkyLight& l = model.update(celestial_state(utc, 43.3623, -8.4115), 0.1, 2.0);
  EXPECT_LT(luminance(l.sun_illuminance), 0.1 * luminance(l.sky_illuminance));
  EXPECT_GT(l.umbra_horizon.x, 2.0 * l.umbra_horizon.z);  // orange, and blue above it
  EXPECT_GT(l.airglow.z, 2.0 * l.airglow.x);
}

TEST(SkyLight, TheSeaIsSeenThroughTheAirThatLiesBefore) {
  // From a mast, a hill and an airliner: what air of such mean extinction lets through is what the
  // way from the sea to the top of the air does, over that from the eye on.
  for (const double haze : {0.1, 0.2, 0.5}) {
    const AirReference reference(haze);
    for (const double height : {10.0, 500.0, 10000.0}) {
      SkyLightModel model;
      shared::FrameData frame{};
      model.update(sky_with(45.0, -40.0, 90.0), haze, height).fill(frame);
      for (const double down_deg : {90.0, 45.0, 15.0}) {
        // A straight ray from a place at sea level; on a sphere its cosine grows on the way.
        const double cosine = std::sin(radians(down_deg)), r = 6360.0, km = height * 1e-3;
        const double along =
            -r * cosine + std::sqrt(r * r * cosine * cosine + 2 * r * km + km * km);
        const double there = (r * cosine + along) / (r + km);
        const glm::dvec3 wanted =
            reference.transmittance(0.0, cosine) / reference.transmittance(km, there);
        for (int c = 0; c < 3; ++c) {
          const double shown = std::exp(-static_cast<double>(frame.haze[c]) * along * 1e3);
          EXPECT_NEAR(shown, wanted[c], 0.01) << haze << " " << height << " " << down_deg;
        }
      }
    }
  }
}

TEST(Eclipse, CoveredAreaOfAnEvenMoon) {
  const double r = 0.00465;
  EXPECT_EQ(uncovered_sun(3.0 * r, r, r), 1.0);
  EXPECT_NEAR(uncovered_sun(0.0, r, 1.02 * r), 1e-6, 1e-7);  // the corona
  // A moon of half the sun's radius in its middle covers a quarter, and the brightest quarter.
  const double annular = uncovered_sun(0.0, r, 0.5 * r);
  EXPECT_LT(annular, 0.75);
  EXPECT_GT(annular, 0.65);
  EXPECT_GT(uncovered_sun(1.5 * r, r, r), uncovered_sun(1.2 * r, r, r));
}

TEST(EyeExposure, NightsAreDarkerThanDaysButNotBlack) {
  EXPECT_GT(3000.0 * eye_exposure(3000.0), 3.0 * (0.01 * eye_exposure(0.01)));
  EXPECT_GT(3e-4 * eye_exposure(3e-4), 0.02);
  for (double l = 1e-5; l < 1e5; l *= 1.1)
    EXPECT_GT(l * 1.1 * eye_exposure(l * 1.1), l * eye_exposure(l) * 0.999);
}

}  // namespace
}  // namespace offing
