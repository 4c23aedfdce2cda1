#include "engine/environment/ephemeris.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "engine/core/angles.h"
#include "engine/core/random.h"
#include "engine/environment/calendar.h"

namespace offing {
namespace {

double utc(const char* date, const char* time) { return *parse_date(date) + *parse_time(time); }

double difference_deg(double a, double b) { return std::abs(degrees(wrap_pi(radians(a - b)))); }

struct Known {
  const char *date, *time;
  double latitude, longitude;
  double sun_azimuth, sun_elevation;
};

class KnownSun : public testing::TestWithParam<Known> {};

TEST_P(KnownSun, StandsWhereAnIndependentEphemerisHasIt) {
  const Known& k = GetParam();
  const CelestialState s = celestial_state(utc(k.date, k.time), k.latitude, k.longitude);
  EXPECT_LT(difference_deg(s.sun.azimuth_deg, k.sun_azimuth), 0.01) << s.sun.azimuth_deg;
  EXPECT_NEAR(s.sun.elevation_deg, k.sun_elevation, 0.01);
}

INSTANTIATE_TEST_SUITE_P(
    Places, KnownSun,
    testing::Values(
        Known{"2026-06-21", "12:00", 59.32938, 18.06871, 206.8164, 52.0280},      // Stockholm
        Known{"2026-12-21", "12:00", 59.32938, 18.06871, 197.0646, 5.9717},       // Stockholm
        Known{"2026-06-21", "00:00", 64.13548, -21.89541, 339.6042, -0.1130},     // Reykjavík
        Known{"2026-03-20", "18:00", -12.04318, -77.02824, 316.8070, 73.6213}));  // Lima

TEST(Ephemeris, MoonStandsWhereAnIndependentEphemerisHasIt) {
  const CelestialState s = celestial_state(utc("2026-06-21", "12:00"), 59.32938, 18.06871);
  EXPECT_LT(difference_deg(s.moon.azimuth_deg, 109.9944), 0.01) << s.moon.azimuth_deg;
  EXPECT_NEAR(s.moon.elevation_deg, 10.6782, 0.01);
}

TEST(Ephemeris, LitFractionOfTheMoon) {
  const auto lit = [](const char* date, const char* time) {
    return celestial_state(utc(date, time), 0.0, 0.0).moon_lit_fraction;
  };
  EXPECT_NEAR(lit("2026-01-03", "12:00"), 0.99855, 5e-4);
  EXPECT_NEAR(lit("2026-01-10", "18:00"), 0.49253, 5e-4);
  EXPECT_NEAR(lit("2026-01-18", "18:00"), 0.00096, 5e-4);
}

TEST(Ephemeris, SiderealTimeOfMeeusExample12) {
  // Mean: 8h 34m 57.0896s; the equation of the equinoxes that day is -0.2317 s (example 12.a).
  const CelestialState s = celestial_state(utc("1987-04-10", "19:21"), 51.0, 0.0);
  EXPECT_NEAR(s.sidereal_time_h * 3600.0, 8 * 3600 + 34 * 60 + 57.0896 - 0.2317, 0.02);
}

TEST(Ephemeris, TheMoonCoversTheSunOffACorunaInAugust2026) {
  const auto separation_arcmin = [](const char* time) {
    const CelestialState s = celestial_state(utc("2026-08-12", time), 43.3623, -8.4115);
    return degrees(std::acos(glm::dot(s.sun.direction(), s.moon.direction()))) * 60.0;
  };
  const CelestialState s = celestial_state(utc("2026-08-12", "18:28"), 43.3623, -8.4115);
  const double margin_arcmin = 60.0 * (s.moon.radius_deg - s.sun.radius_deg);
  EXPECT_NEAR(separation_arcmin("18:28"), 0.43, 0.1);
  EXPECT_LT(separation_arcmin("18:28"), margin_arcmin);
  EXPECT_GT(separation_arcmin("18:20"), margin_arcmin);
  EXPECT_GT(separation_arcmin("18:36"), margin_arcmin);
}

TEST(Ephemeris, OtherEclipsesBeginAndEndWhenTheyDid) {
  struct Eclipse {
    const char *date, *begins, *ends;  // second and third contact
    double latitude, longitude;
    bool total;  // or a ring of sun is left
  };
  // As published for the places before (Espenak, NASA), to a second; Carbondale's to the minute,
  // with its length to a second.
  for (const Eclipse& e :
       {Eclipse{"2017-08-21", "18:20:12", "18:22:50", 37.727, -89.217, true},    // Carbondale
        Eclipse{"2023-10-14", "16:34:34", "16:39:22", 35.084, -106.65, false},   // Albuquerque
        Eclipse{"2024-04-08", "18:40:43", "18:44:35", 32.7767, -96.797, true}})  // Dallas
  {
    const auto within = [&](double seconds) {
      const CelestialState s = celestial_state(seconds, e.latitude, e.longitude);
      const double apart = degrees(std::acos(glm::dot(s.sun.direction(), s.moon.direction())));
      const double wider = s.moon.radius_deg - s.sun.radius_deg;
      return apart < (e.total ? wider : -wider);
    };
    constexpr double kSeconds = 20.0;  // the moon's limb is not round, its radius a convention
    EXPECT_FALSE(within(utc(e.date, e.begins) - kSeconds)) << e.date;
    EXPECT_TRUE(within(utc(e.date, e.begins) + kSeconds)) << e.date;
    EXPECT_TRUE(within(utc(e.date, e.ends) - kSeconds)) << e.date;
    EXPECT_FALSE(within(utc(e.date, e.ends) + kSeconds)) << e.date;
  }
}

// The Astronomical Almanac's low-precision formulas ("page C5" and "page D46"), which share nothing
// with the series used: sun to 0.01 degrees, moon to about 0.3.
struct Almanac {
  glm::dvec3 sun, moon;  ///< equatorial of date, geocentric; moon in earth radii
};

Almanac almanac(double seconds) {
  const double n = seconds / 86400.0 + 2440587.5 + 65.0 / 86400.0 - 2451545.0;
  const double t = n / 36525.0;
  const auto sin_deg = [](double a) { return std::sin(radians(std::fmod(a, 360.0))); };
  const auto cos_deg = [](double a) { return std::cos(radians(std::fmod(a, 360.0))); };
  const auto equatorial = [&](double longitude, double latitude) {
    const double e = radians(23.439 - 4e-7 * n);
    const double x = cos_deg(latitude) * cos_deg(longitude);
    const double y = cos_deg(latitude) * sin_deg(longitude), z = sin_deg(latitude);
    return glm::dvec3(x, y * std::cos(e) - z * std::sin(e), y * std::sin(e) + z * std::cos(e));
  };
  const double g = 357.528 + 0.9856003 * n;
  const double sun = 280.460 + 0.9856474 * n + 1.915 * sin_deg(g) + 0.020 * sin_deg(2 * g);
  const double moon = 218.32 + 481267.881 * t + 6.29 * sin_deg(135.0 + 477198.87 * t) -
                      1.27 * sin_deg(259.3 - 413335.36 * t) +
                      0.66 * sin_deg(235.7 + 890534.22 * t) +
                      0.21 * sin_deg(269.9 + 954397.74 * t) - 0.19 * sin_deg(357.5 + 35999.05 * t) -
                      0.11 * sin_deg(186.5 + 966404.03 * t);
  const double beta = 5.13 * sin_deg(93.3 + 483202.02 * t) + 0.28 * sin_deg(228.2 + 960400.89 * t) -
                      0.28 * sin_deg(318.3 + 6003.15 * t) - 0.17 * sin_deg(217.6 - 407332.21 * t);
  const double parallax =
      0.9508 + 0.0518 * cos_deg(135.0 + 477198.87 * t) + 0.0095 * cos_deg(259.3 - 413335.36 * t) +
      0.0078 * cos_deg(235.7 + 890534.22 * t) + 0.0028 * cos_deg(269.9 + 954397.74 * t);
  return {equatorial(sun, 0.0), equatorial(moon, beta) / sin_deg(parallax)};
}

TEST(Ephemeris, AgreesWithTheAlmanacAtRandomDatesAndPlaces) {
  const double first = utc("1950-01-01", "00:00"), last = utc("2099-12-31", "00:00");
  for (unsigned i = 0; i < 60; ++i) {
    const double seconds = first + (last - first) * random_uniform(1, 0, i);
    const double latitude = -88.0 + 176.0 * random_uniform(1, 1, i);
    const double longitude = -180.0 + 360.0 * random_uniform(1, 2, i);
    const CelestialState s = celestial_state(seconds, latitude, longitude);
    const Almanac a = almanac(seconds);
    // Greenwich mean sidereal time 1982, then place and horizon by plain trigonometry on a sphere.
    const double n = seconds / 86400.0 + 2440587.5 - 2451545.0;
    const double local = radians(std::fmod(280.46061837 + 360.98564736629 * n, 360.0) + longitude);
    const double phi = radians(latitude);
    const glm::dvec3 up(std::cos(phi) * std::cos(local), std::cos(phi) * std::sin(local),
                        std::sin(phi));
    const auto check = [&](glm::dvec3 body, const SkyPosition& ours, double tolerance) {
      const glm::dvec3 d = glm::normalize(body);
      const glm::dvec3 east(-std::sin(local), std::cos(local), 0.0);
      const glm::dvec3 north = glm::cross(up, east);
      SkyPosition airless;
      airless.azimuth_deg = ours.azimuth_deg;
      airless.elevation_deg = ours.elevation_airless_deg;
      const glm::dvec3 theirs(glm::dot(d, east), glm::dot(d, up), -glm::dot(d, north));
      EXPECT_LT(degrees(std::acos(std::min(1.0, glm::dot(theirs, airless.direction())))), tolerance)
          << date_text(seconds) << " " << time_text(seconds) << " " << latitude << " " << longitude;
    };
    check(a.sun * 23455.0 - up, s.sun, seconds < utc("2050-01-01", "00:00") ? 0.02 : 0.03);
    check(a.moon - up, s.moon, 0.45);
  }
}

TEST(Ephemeris, RunningClockGivesWhatASingleCallGives) {
  Ephemeris running;
  const double start = utc("2026-08-12", "15:30");
  for (int step = -40; step < 40; ++step) {
    const double seconds = start + 1237.0 * step;
    const CelestialState a = running.at(seconds, 43.0, -8.0);
    const CelestialState b = celestial_state(seconds, 43.0, -8.0);
    EXPECT_EQ(a.moon.azimuth_deg, b.moon.azimuth_deg);
    EXPECT_EQ(a.sun.elevation_deg, b.sun.elevation_deg);
  }
}

TEST(Ephemeris, InterpolationBetweenKnotsIsSmooth) {
  // Second differences of a smooth path; a wrong knot would jump by degrees.
  Ephemeris running;
  const double start = utc("2026-08-12", "11:58");  // a knot lies at 12:00
  double worst = 0.0, a = running.at(start, 43.0, -8.0).moon.elevation_airless_deg;
  double b = running.at(start + 10.0, 43.0, -8.0).moon.elevation_airless_deg;
  for (int i = 2; i < 24; ++i) {
    const double c = running.at(start + 10.0 * i, 43.0, -8.0).moon.elevation_airless_deg;
    worst = std::max(worst, std::abs(c - 2.0 * b + a));
    a = b;
    b = c;
  }
  EXPECT_LT(worst, 1e-4);
}

TEST(Refraction, KnownValuesAndSmoothBelowTheHorizon) {
  EXPECT_NEAR(refraction_deg(0.0) * 60.0, 28.98, 0.1);  // Saemundsson: true elevation 0
  EXPECT_NEAR(refraction_deg(45.0) * 60.0, 1.01, 0.02);
  EXPECT_NEAR(refraction_deg(90.0), 0.0, 1e-4);
  EXPECT_NEAR(refraction_deg(-0.5667) * 60.0, 34.5, 0.7);  // a body that is seen on the horizon
  EXPECT_EQ(refraction_deg(-10.0), 0.0);
  double slope_before = (refraction_deg(-0.79) - refraction_deg(-0.8)) / 0.01;
  for (double e = -0.8; e > -6.0; e -= 0.01) {
    const double slope = (refraction_deg(e) - refraction_deg(e - 0.01)) / 0.01;
    EXPECT_LT(std::abs(slope - slope_before), 0.01) << e;  // no kink
    EXPECT_GT(slope, -0.9) << e;                           // what is lower is seen lower
    slope_before = slope;
  }
}

}  // namespace
}  // namespace offing
