#include "engine/environment/environment.h"

#include <gtest/gtest.h>

#include <vector>

#include "engine/core/error.h"
#include "engine/environment/calendar.h"

namespace offing {
namespace {

TEST(Calendar, KnownDays) {
  EXPECT_EQ(parse_date("1970-01-01"), 0.0);
  EXPECT_EQ(parse_date("2000-03-01"), 951868800.0);
  EXPECT_EQ(parse_date("1600-01-01"), -11676096000.0);
  EXPECT_EQ(parse_time("18:30"), 66600.0);
  EXPECT_EQ(parse_time("23:59:59"), 86399.0);
}

TEST(Calendar, TextAndBack) {
  for (const char* date : {"1600-01-01", "1900-02-28", "2000-02-29", "2026-08-12", "2200-12-31"}) {
    EXPECT_EQ(date_text(*parse_date(date)), date);
    EXPECT_EQ(date_text(*parse_date(date) + 86399.5), date);
  }
  EXPECT_EQ(time_text(*parse_date("1650-05-05") + *parse_time("07:08:09")), "07:08:09");
  EXPECT_EQ(date_text(first_utc_seconds()), "1600-01-01");
  EXPECT_EQ(date_text(last_utc_seconds()), "2200-12-31");
}

TEST(Calendar, RefusesWhatIsNoDate) {
  const auto why = [](const char* text) {
    std::string problem;
    EXPECT_FALSE(parse_date(text, &problem)) << text;
    return problem;
  };
  EXPECT_EQ(why("2026-02-30"), "must have a day from 01 to 28 in 2026-02");
  EXPECT_EQ(why("1900-02-29"), "must have a day from 01 to 28 in 1900-02");
  EXPECT_EQ(why("2026-13-01"), "must have a month from 01 to 12");
  EXPECT_EQ(why("2026-00-10"), "must have a month from 01 to 12");
  EXPECT_EQ(why("1599-12-31"), "must be a date from 1600 to 2200");
  EXPECT_EQ(why("2201-01-01"), "must be a date from 1600 to 2200");
  for (const char* text :
       {"", "today", "2026-8-12", "12.08.2026", "2026-08-1x", "2026-08-12 ", "-026-08-12"}) {
    EXPECT_EQ(why(text), "must be YYYY-MM-DD, as 2026-06-21") << text;
  }
}

TEST(Calendar, RefusesWhatIsNoTime) {
  for (const char* text :
       {"", "24:00", "12:60", "12:00:60", "1200", "12:3", "12-30", "-1:00", "12:00:0", "12:00Z"}) {
    std::string problem;
    EXPECT_FALSE(parse_time(text, &problem)) << text;
    EXPECT_EQ(problem.rfind("must be", 0), 0u) << text;
  }
}

TEST(Environment, FieldsReachTheObject) {
  Environment e;
  FieldTable table;
  e.describe(table);
  EXPECT_EQ(e.date(), "2026-08-12");
  table.set_from_text("environment.date", "2026-06-21", "test");
  table.set_from_text("environment.time", "18:30", "test");
  table.set_from_text("environment.wind.speed", "12.5", "test");
  table.set_from_text("environment.clouds.type", "0.5", "test");
  table.set_from_text("environment.latitude", "-33.9", "test");
  e.apply_fields();
  EXPECT_EQ(e.utc_seconds(), *parse_date("2026-06-21") + *parse_time("18:30"));
  EXPECT_EQ(e.time(), "18:30:00");
  EXPECT_EQ(e.wind.speed, 12.5);
  EXPECT_EQ(e.clouds.type, 0.5);
  EXPECT_EQ(e.latitude_deg, -33.9);
}

TEST(Environment, BadFieldsAreRefused) {
  Environment e;
  FieldTable table;
  e.describe(table);
  const char* bad[][2] = {{"date", "2026-02-30"},  {"date", "1599-12-31"}, {"time", "25:00"},
                          {"wind.speed", "-3"},    {"wind.speed", "61"},   {"latitude", "90.5"},
                          {"longitude", "200"},    {"gusts", "2"},         {"haze", "nan"},
                          {"clouds.cover", "-0.1"}};
  for (const auto& [key, value] : bad) {
    EXPECT_THROW(table.set_from_text(std::string("environment.") + key, value, "test"), InputError)
        << key << " " << value;
  }
  EXPECT_EQ(e.date(), "2026-08-12");
  EXPECT_EQ(e.wind.speed, Wind().speed);
}

TEST(Environment, ClockRunsPausesAndTurnsBack) {
  Environment e;
  const double start = e.utc_seconds();
  e.clock_rate = 60.0;
  for (int i = 0; i < 120; ++i) e.advance(1.0 / 120.0);
  EXPECT_NEAR(e.utc_seconds() - start, 60.0, 1e-6);
  EXPECT_NEAR(e.elapsed(), 1.0, 1e-9);
  EXPECT_EQ(e.time(), "15:31:00");
  e.paused = true;
  e.advance(10.0);
  EXPECT_NEAR(e.elapsed(), 1.0, 1e-9);
  e.paused = false;
  e.clock_rate = -3600.0;
  e.advance(24.0);
  EXPECT_EQ(e.date(), "2026-08-11");
  EXPECT_NEAR(e.elapsed(), 25.0, 1e-9);
}

TEST(Environment, ApplyingUnchangedFieldsKeepsTheFraction) {
  Environment e;
  e.advance(0.25);
  const double before = e.utc_seconds();
  e.apply_fields();
  EXPECT_EQ(e.utc_seconds(), before);
}

TEST(Environment, TheClockStopsAtTheEndsOfTheCalendar) {
  Environment e;
  e.set_utc_seconds(1e12);
  EXPECT_EQ(e.date(), "2200-12-31");
  e.set_utc_seconds(-1e12);
  EXPECT_EQ(e.date(), "1600-01-01");
}

TEST(Environment, PacesOfTheClockGoFromADayBackInAMinuteToADayForth) {
  Environment e;
  std::vector<double> up, down;
  e.clock_rate = -1440.0;
  for (int i = 0; i < 6; ++i, e.quicken()) up.push_back(e.clock_rate);
  EXPECT_EQ(up, (std::vector<double>{-1440, -60, -1, 1, 60, 1440}));
  EXPECT_EQ(e.clock_rate, 1440.0);  // no faster
  for (int i = 0; i < 6; ++i, e.slow_down()) down.push_back(e.clock_rate);
  EXPECT_EQ(down, (std::vector<double>{1440, 60, 1, -1, -60, -1440}));
  e.clock_rate = 0.0;  // from any other pace to the next
  e.quicken();
  EXPECT_EQ(e.clock_rate, 1.0);
  e.clock_rate = 100.0;
  e.slow_down();
  EXPECT_EQ(e.clock_rate, 60.0);
  // A day in a minute, there and back: the same second again.
  const double start = e.utc_seconds();
  e.clock_rate = 1440.0;
  for (int i = 0; i < 3600; ++i) e.advance(1.0 / 60.0);
  EXPECT_NEAR(e.utc_seconds() - start, 86400.0, 1e-3);
  e.clock_rate = -1440.0;
  for (int i = 0; i < 3600; ++i) e.advance(1.0 / 60.0);
  EXPECT_NEAR(e.utc_seconds(), start, 1e-3);
}

TEST(Environment, CelestialFollowsClockAndPlace) {
  Environment e;
  const double azimuth = e.celestial().sun.azimuth_deg;
  EXPECT_EQ(e.celestial().sun.azimuth_deg, azimuth);
  e.set_utc_seconds(e.utc_seconds() + 3600.0);
  EXPECT_GT(e.celestial().sun.azimuth_deg, azimuth + 5.0);
  const double elevation = e.celestial().sun.elevation_deg;
  e.longitude_deg += 30.0;
  EXPECT_NE(e.celestial().sun.elevation_deg, elevation);
}

}  // namespace
}  // namespace offing
