#include "engine/sky/palette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "engine/core/angles.h"
#include "engine/core/error.h"
#include "engine/environment/calendar.h"
#include "engine/io/file.h"
#include "support/scratch_folder.h"

namespace offing {
namespace {
namespace fs = std::filesystem;

double luminance(glm::dvec3 c) { return glm::dot(c, glm::dvec3(0.2126, 0.7152, 0.0722)); }

struct PaletteFile : testing::Test {
  static std::string frame(const std::string& hour, const std::string& replace = "",
                           const std::string& with = "") {
    std::string text =
        "[[frame]]\nhour = " + hour +
        "\nzenith = \"#204080\"\nmiddle = \"#4080c0\"\nhorizon = \"#c0d0e0\"\n"
        "luminance = [1000.0, 2000.0, 4000.0]\nsun = \"#fff0e0\"\nsun_lux = 50000.0\n"
        "moon = \"#ffffff\"\nmoon_lux = 0.2\n";
    if (!replace.empty()) text.replace(text.find(replace), replace.size(), with);
    return text;
  }
  Palette load(const std::string& text) {
    write_text(file, text);
    return load_palette(file);
  }
  /// What is said after the file's name.
  std::string refusal(const std::string& text) {
    try {
      load(text);
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      EXPECT_EQ(message.find(file.string() + ":"), 0u) << message;
      return message.substr(std::min(message.size(), file.string().size()));
    }
    ADD_FAILURE() << "was not refused: " << text;
    return "";
  }
  const test::ScratchFolder scratch;
  const fs::path file = scratch / "palette.toml";
};

TEST_F(PaletteFile, WhatIsWrongIsNamedWithItsLine) {
  const auto starts = [&](const std::string& text, const std::string& start) {
    const std::string said = refusal(text);
    EXPECT_EQ(said.substr(0, start.size()), start) << said;
  };
  const std::string good = frame("6.0");
  starts(frame("12.0") + frame("6.0"), ":12: frame 2: hour: 6 must be later than 12");
  starts(frame("12.0") + frame("12.0"), ":12: frame 2: hour: 12 must be later than 12");
  starts(good, ":1: has one [[frame]]");
  starts("", ":1: has no [[frame]]");
  starts(good + frame("24.0"), ":12: frame 2: hour: must be less than 24");
  starts(good + frame("-1.0"), ":12: frame 2: hour: must be a number from 0");
  starts(good + frame("nan"), ":12: frame 2: hour: must be a number from 0");
  starts(good + frame("\"noon\""), ":12: frame 2: hour: must be a number from 0");
  starts(good + frame("9.0", "horizon = \"#c0d0e0\"\n", ""), ":11: frame 2: horizon: is missing");
  starts(good + frame("9.0", "#204080", "blue"), ":13: frame 2: zenith: must be a colour");
  starts(good + frame("9.0", "#204080", "#20408g"), ":13: frame 2: zenith: must be a colour");
  starts(good + frame("9.0", "#204080", "#000000"), ":13: frame 2: zenith: must not be black");
  starts(good + frame("9.0", "sun_lux = 50000.0", "sun_lux = -1.0"), ":18: frame 2: sun_lux: must");
  starts(good + frame("9.0", "sun_lux = 50000.0", "sun_lux = inf"), ":18: frame 2: sun_lux: must");
  starts(good + frame("9.0", "[1000.0, 2000.0, 4000.0]", "[1000.0, 2000.0]"),
         ":16: frame 2: luminance: must be three");
  starts(good + frame("9.0", "[1000.0, 2000.0, 4000.0]", "[1000.0, 0.0, 4000.0]"),
         ":16: frame 2: luminance: must be a number");
  starts(good + frame("9.0", "moon_lux", "moon_luxx"), ":20: frame 2: moon_luxx: is no field");
  starts("name = \"x\"\n" + good + frame("9.0"), ":1: name: a palette is a list");
  starts("frame = 3\n", ":1: frame: a palette is a list");
  starts("[[frame]\n", ":1: not TOML");
  EXPECT_THROW(load_palette("no/such/palette.toml"), InputError);
}

TEST_F(PaletteFile, RunsThroughTheDayAndPastMidnight) {
  const Palette palette =
      load(frame("6.0") + frame("18.0", "[1000.0, 2000.0, 4000.0]", "[10.0, 20.0, 40.0]"));
  // By decades: a third of the way from 1000 to 10.
  EXPECT_NEAR(palette.at(10.0).luminance.x, 1000.0 * std::pow(0.01, 1.0 / 3.0), 1e-9);
  EXPECT_NEAR(palette.at(12.0).luminance.y, 200.0, 1e-9);
  EXPECT_NEAR(palette.at(0.0).luminance.y, 200.0, 1e-9);  // across midnight
  EXPECT_NEAR(palette.at(6.0).luminance.z, 4000.0, 1e-9);
  EXPECT_NEAR(palette.at(18.0).luminance.z, 40.0, 1e-9);
  for (double hour : {-30.0, -1.0, 0.0, 3.7, 23.9, 24.0, 100.1}) {
    EXPECT_NEAR(palette.at(hour).luminance.x, palette.at(hour + 24.0).luminance.x, 1e-6) << hour;
    EXPECT_NEAR(luminance(palette.at(hour).middle), 1.0, 1e-12);
  }
  EXPECT_NEAR(luminance(palette.at(3.0).zenith), 1.0, 1e-12);
  // "#c0d0e0" by the formula of sRGB.
  const auto linear = [](double c) { return std::pow((c / 255.0 + 0.055) / 1.055, 2.4); };
  const glm::dvec3 horizon(linear(0xc0), linear(0xd0), linear(0xe0));
  EXPECT_LT(glm::length(palette.at(6.0).horizon - horizon / luminance(horizon)), 1e-12);
}

TEST(Palette, TheShippedOneHasAFrameEveryThreeHours) {
  const Palette day = load_palette(find_palette("day"));
  ASSERT_EQ(day.frames.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(day.frames[i].hour, 3.0 * static_cast<double>(i));
  EXPECT_GT(day.at(12.0).luminance.y, 1000.0 * day.at(0.0).luminance.y);
  EXPECT_GT(luminance(day.at(12.0).sun) * day.at(12.0).sun_lux, 5e4);
  EXPECT_EQ(day.at(0.0).sun_lux, 0.0);
  // No step: in a minute the brightness of the sky changes by a few per cent at most.
  for (int minute = 0; minute < 1440; ++minute) {
    const double a = day.at(minute / 60.0).luminance.y, b = day.at((minute + 1) / 60.0).luminance.y;
    EXPECT_LT(std::abs(std::log(b / a)), 0.1) << minute;
  }
}

TEST(Palette, SolarHour) {
  const double noon = *parse_date("2026-03-01") + 12 * 3600.0;
  EXPECT_NEAR(solar_hour(noon, 0.0), 12.0, 1e-6);
  EXPECT_NEAR(solar_hour(noon, -90.0), 6.0, 1e-6);
  EXPECT_NEAR(solar_hour(noon, 180.0), 0.0, 1e-6);
  EXPECT_NEAR(solar_hour(-3600.0, 0.0), 23.0, 1e-6);
}

SkyLight light_at(const char* time) {
  SkyLightModel model;
  return model.update(celestial_state(*parse_date("2026-06-21") + *parse_time(time), 43.0, -8.0),
                      0.1, 2.0);
}

TEST(Palette, AGradeKeepsTheBrightnessAndTakesTheColour) {
  const PaletteFrame noon = load_palette(find_palette("day")).at(12.0);
  const SkyLight physical = light_at("12:30");
  SkyLight light = physical;
  apply_palette(light, noon, PaletteMode::kGrade, 1.0);
  EXPECT_NEAR(luminance(light.sky_illuminance), luminance(physical.sky_illuminance),
              1e-6 * luminance(physical.sky_illuminance));
  EXPECT_NEAR(luminance(light.sun_illuminance), luminance(physical.sun_illuminance), 1e-3);
  EXPECT_LT(glm::length(light.sun_illuminance / luminance(light.sun_illuminance) - noon.sun), 1e-9);
  EXPECT_NEAR(light.exposure, physical.exposure, 1e-9);
  light = physical;
  apply_palette(light, noon, PaletteMode::kGrade, 0.0);
  EXPECT_LT(glm::length(light.sun_illuminance - physical.sun_illuminance), 1e-6);
  light = physical;
  apply_palette(light, noon, PaletteMode::kOff, 1.0);
  EXPECT_EQ(light.painted.mode, PaletteMode::kOff);
}

TEST(Palette, InPlaceOfTheSkyItIsTheSky) {
  const PaletteFrame noon = load_palette(find_palette("day")).at(12.0);
  SkyLight light = light_at("12:30");
  apply_palette(light, noon, PaletteMode::kReplace, 0.3);
  EXPECT_NEAR(luminance(light.sun_illuminance), noon.sun_lux, 1e-3 * noon.sun_lux);
  // Illuminance of a level surface: the curve from horizon to zenith, integrated.
  const PaintedSky& sky = light.painted;
  double lux = 0.0;
  constexpr int kSteps = 20000;
  for (int i = 0; i < kSteps; ++i) {
    const double sine = (i + 0.5) / kSteps, w = std::sqrt(sine);
    lux += kTau * sine / kSteps *
           luminance((1 - w) * (1 - w) * sky.horizon + 2 * w * (1 - w) * sky.middle +
                     w * w * sky.zenith);
  }
  EXPECT_NEAR(luminance(light.sky_illuminance) / lux, 1.0, 1e-4);
  EXPECT_TRUE(std::isfinite(light.exposure) && light.exposure > 0.0);
  // By night the sun gives nothing, wherever it stands.
  SkyLight night = light_at("01:00");
  apply_palette(night, load_palette(find_palette("day")).at(0.0), PaletteMode::kReplace, 1.0);
  EXPECT_EQ(luminance(night.sun_illuminance), 0.0);
  EXPECT_LT(night.level_illuminance(), 1.0);
}

}  // namespace
}  // namespace offing
