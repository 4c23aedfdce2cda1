// The CPU's light through whole days, minute by minute.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <thread>

#include "engine/core/angles.h"
#include "engine/environment/calendar.h"
#include "engine/sky/sky_light.h"

namespace offing {
namespace {

double luminance(glm::dvec3 c) { return glm::dot(c, glm::dvec3(0.2126, 0.7152, 0.0722)); }

struct Day {
  const char* date;
  double latitude, longitude;
};

/// How far the middle of three values that follow each other lies from what its neighbours say,
/// as a ratio. A light that falls steadily by decades gives 0, however fast it falls.
double step(double a, double b, double c) { return std::abs(std::log(b * b / (a * c))); }

class WholeDay : public testing::TestWithParam<Day> {};

TEST_P(WholeDay, TurnsWithoutAStep) {
  const Day& day = GetParam();
  SkyLightModel model(Starlight(load_stars(star_file()), load_milky_way(milky_way_file())));
  Ephemeris ephemeris;
  std::vector<SkyLight> lights;
  for (int minute = -1; minute <= 1440; ++minute) {
    const double utc = *parse_date(day.date) + 60.0 * minute;
    lights.push_back(model.update(ephemeris.at(utc, day.latitude, day.longitude), 0.1, 3.0));
  }
  double worst_sky = 0.0, worst_exposed = 0.0, worst_level = 0.0, worst_tint = 0.0;
  for (std::size_t i = 1; i + 1 < lights.size(); ++i) {
    const SkyLight &a = lights[i - 1], &b = lights[i], &c = lights[i + 1];
    for (const glm::dvec3& v : {b.sun_illuminance, b.moon_illuminance, b.sky_illuminance}) {
      for (int k = 0; k < 3; ++k) ASSERT_TRUE(std::isfinite(v[k]) && v[k] >= 0.0) << i;
    }
    ASSERT_TRUE(std::isfinite(b.exposure) && b.exposure > 0.0) << i;
    const auto sky = [](const SkyLight& l) { return luminance(l.sky_illuminance); };
    const auto exposed = [&](const SkyLight& l) { return sky(l) * l.exposure; };
    const auto level = [](const SkyLight& l) { return l.level_illuminance(); };
    const auto blue = [](const SkyLight& l) { return l.sky_illuminance.z / l.sky_illuminance.x; };
    worst_sky = std::max(worst_sky, step(sky(a), sky(b), sky(c)));
    worst_exposed = std::max(worst_exposed, step(exposed(a), exposed(b), exposed(c)));
    worst_level = std::max(worst_level, step(level(a), level(b), level(c)));
    worst_tint = std::max(worst_tint, step(blue(a), blue(b), blue(c)));
    // What the eye is shown: dusk at sea dims the picture to a tenth in an hour or so.
    EXPECT_LT(std::abs(std::log(exposed(b) / exposed(a))), 0.12) << i;
    EXPECT_LT(std::abs(b.star_share - a.star_share), 0.25) << i;
  }
  EXPECT_LT(worst_sky, 0.03);
  EXPECT_LT(worst_exposed, 0.03);
  EXPECT_LT(worst_level, 0.03);
  EXPECT_LT(worst_tint, 0.03);
  RecordProperty("worst_sky", std::to_string(worst_sky));
  RecordProperty("worst_exposed", std::to_string(worst_exposed));
  RecordProperty("worst_level", std::to_string(worst_level));
}

INSTANTIATE_TEST_SUITE_P(Days, WholeDay,
                         testing::Values(Day{"2026-06-21", 43.3623, -8.4115},  // moon sets at night
                                         Day{"2026-08-27", 43.3623, -8.4115},  // nearly full moon
                                         Day{"2026-12-05", 0.0, 90.0},         // quickest dusk
                                         Day{"2026-03-20", 69.6, 18.9},        // long twilight
                                         Day{"2026-06-30", 80.0, 10.0}));      // midnight sun

TEST(SkyDay, TheLightFollowsAnEclipseWithoutAStepEither) {
  // Totality comes within seconds: ten a minute show it. In 6 s the moon moves by no more than 5
  // arc seconds against the sun, of radius 948: its limb sweeps over at most 2 * 5 / (948 pi) of
  // the disc, 1.25 times as bright in the middle as on average.
  constexpr double kMost = 1.25 * 2.0 * 5.0 / (948.0 * kPi);
  SkyLightModel model;
  Ephemeris ephemeris;
  double last = -1.0, least = 1.0;
  for (int i = -600; i <= 600; ++i) {
    const double utc = *parse_date("2026-08-12") + *parse_time("18:28") + 6.0 * i;
    const SkyLight& l = model.update(ephemeris.at(utc, 43.3623, -8.4115), 0.1, 3.0);
    if (last >= 0.0) {
      EXPECT_LT(std::abs(l.sun_uncovered - last), kMost) << i;
    }
    last = l.sun_uncovered;
    least = std::min(least, last);
    ASSERT_GT(l.level_illuminance(), 0.0);
  }
  EXPECT_LT(least, 1e-4);
}

TEST(SkyDay, ATotalLunarEclipseIsRedAndDim) {
  SkyLightModel model;
  const auto at = [&](const char* time) {
    return model.update(
        celestial_state(*parse_date("2025-03-14") + *parse_time(time), 20.0, -100.0), 0.1, 3.0);
  };
  const SkyLight before = at("03:00"), total = at("06:58"), after = at("11:00");
  const double dimmed = luminance(total.moon_source) / luminance(before.moon_source);
  EXPECT_LT(dimmed, 1e-3);  // seven magnitudes and more
  EXPECT_GT(dimmed, 1e-6);
  EXPECT_GT(total.moon_source.x, 2.5 * total.moon_source.z);
  EXPECT_NEAR(luminance(after.moon_source) / luminance(before.moon_source), 1.0, 0.15);
}

TEST(SkyDay, AnotherHazeInTheBackgroundEndsInTheSameLight) {
  SkyLightModel at_once, waiting;
  waiting.set_in_background(true);
  const CelestialState s = celestial_state(*parse_date("2026-06-21") + 43200.0, 43.0, -8.0);
  at_once.update(s, 0.1, 3.0);
  const double first = luminance(waiting.update(s, 0.1, 3.0).sky_illuminance);
  const double wanted = luminance(at_once.update(s, 0.4, 3.0).sky_illuminance);
  ASSERT_GT(std::abs(wanted - first), 100.0);
  double now = luminance(waiting.update(s, 0.4, 3.0).sky_illuminance);
  EXPECT_TRUE(now == first || now == wanted);
  for (int i = 0; i < 5000 && now != wanted; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    now = luminance(waiting.update(s, 0.4, 3.0).sky_illuminance);
  }
  EXPECT_EQ(now, wanted);
}

TEST(SkyDay, MoonlessNightIsAboutAMillilux) {
  // 2026-08-13, 23:00 UTC at A Coruña: neither sun nor moon lights the sky.
  SkyLightModel model(Starlight(load_stars(star_file()), load_milky_way(milky_way_file())));
  const double utc = *parse_date("2026-08-13") + *parse_time("23:30");
  const SkyLight& l = model.update(celestial_state(utc, 43.3623, -8.4115), 0.1, 3.0);
  EXPECT_LT(l.sun_direction.y, std::sin(radians(-18.0)));
  EXPECT_LT(l.moon_direction.y, 0.0);
  EXPECT_GT(l.level_illuminance(), 0.6e-3);
  EXPECT_LT(l.level_illuminance(), 1.6e-3);
}

}  // namespace
}  // namespace offing
