#include "engine/core/fields.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "engine/core/error.h"

namespace offing {
namespace {

struct Sea {
  bool swell = true;
  int seed = 1;
  double speed = 8.0;
  glm::dvec2 position{0.0};
  glm::dvec3 target{0.0};
  int spectrum = 1;
  std::string date = "2026-06-21";
};

std::string check_date(std::string_view text) {
  return text.size() == 10 ? "" : "must be a date such as 2026-06-21";
}

struct Fields : testing::Test {
  Fields() {
    table.group("environment.wind").number("speed", sea.speed, {0, 60}, "m/s", "wind at 10 m");
    table.group("boat").vector("position", sea.position, {-1000, 1000}, "m", "x,z");
    table.group("camera").vector("target", sea.target, {-1000, 1000}, "m", "x,y,z");
    table.group("sea")
        .choice("spectrum", sea.spectrum, {"pm", "jonswap", "tma"}, "wave spectrum")
        .flag("swell", sea.swell, "a second sea");
    table.group("environment").text("date", sea.date, "UTC", check_date);
    table.group("").integer("seed", sea.seed, {0, 1000}, "of everything random");
  }

  std::string text_refusal(std::string_view key, std::string_view text) {
    return message([&] { table.set_from_text(key, text, "--set"); });
  }
  std::string refusal(std::string_view key, const FieldValue& value) {
    return message([&] { table.set(key, value, "gale.toml:12"); });
  }

  Sea sea;
  FieldTable table;

 private:
  template <class Function>
  std::string message(Function&& set) {
    std::vector<std::string> before, after;
    for (const Field& field : table.fields()) before.push_back(FieldTable::to_text(field));
    std::string said;
    try {
      set();
      ADD_FAILURE() << "was not refused";
    } catch (const InputError& error) {
      said = error.what();
    }
    for (const Field& field : table.fields()) after.push_back(FieldTable::to_text(field));
    EXPECT_EQ(before, after) << "a refused value changed something";
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    return said;
  }
};

TEST_F(Fields, SetsEveryTypeFromValues) {
  table.set("environment.wind.speed", 12.5, "here");
  table.set("seed", 7.0, "here");
  table.set("sea.swell", false, "here");
  table.set("sea.spectrum", std::string("tma"), "here");
  table.set("environment.date", std::string("2027-01-02"), "here");
  table.set("boat.position", std::vector{1.0, -2.0}, "here");
  table.set("camera.target", std::vector{1.0, 2.0, 3.0}, "here");
  EXPECT_EQ(sea.speed, 12.5);
  EXPECT_EQ(sea.seed, 7);
  EXPECT_FALSE(sea.swell);
  EXPECT_EQ(sea.spectrum, 2);
  EXPECT_EQ(sea.date, "2027-01-02");
  EXPECT_EQ(sea.position, glm::dvec2(1.0, -2.0));
  EXPECT_EQ(sea.target, glm::dvec3(1.0, 2.0, 3.0));
}

TEST_F(Fields, SetsEveryTypeFromText) {
  table.set_from_text("environment.wind.speed", "1.25e1", "--set");
  table.set_from_text("seed", "7", "--set");
  table.set_from_text("sea.swell", "false", "--set");
  table.set_from_text("sea.spectrum", "pm", "--set");
  table.set_from_text("environment.date", "2027-01-02", "--set");
  table.set_from_text("boat.position", "1, -2", "--set");
  table.set_from_text("camera.target", "10,2,-30", "--set");
  EXPECT_EQ(sea.speed, 12.5);
  EXPECT_EQ(sea.seed, 7);
  EXPECT_FALSE(sea.swell);
  EXPECT_EQ(sea.spectrum, 0);
  EXPECT_EQ(sea.date, "2027-01-02");
  EXPECT_EQ(sea.position, glm::dvec2(1.0, -2.0));
  EXPECT_EQ(sea.target, glm::dvec3(10.0, 2.0, -30.0));
}

TEST_F(Fields, TextComesBackExactly) {
  for (const double speed : {0.0, 0.1, 1.0 / 3.0, 59.999999999999993, 5e-324}) {
    sea.speed = speed;
    sea.target = {-speed, 1.0 / 7.0, 100.0 * speed / 7.0};
    const Sea written = sea;
    std::vector<std::string> texts;
    for (const Field& field : table.fields()) texts.push_back(FieldTable::to_text(field));
    sea = Sea{false, 0, 1.0, {5.0, 5.0}, {5.0, 5.0, 5.0}, 0, "0000-00-00"};
    for (std::size_t i = 0; i < texts.size(); ++i) {
      table.set_from_text(table.fields()[i].key, texts[i], "--set");
    }
    EXPECT_EQ(sea.speed, written.speed);
    EXPECT_EQ(sea.target, written.target);
    EXPECT_EQ(sea.swell, written.swell);
    EXPECT_EQ(sea.spectrum, written.spectrum);
    EXPECT_EQ(sea.seed, written.seed);
    EXPECT_EQ(sea.date, written.date);
  }
}

TEST_F(Fields, OutOfRangeSaysWhatIsAllowed) {
  EXPECT_EQ(refusal("environment.wind.speed", -3.0),
            "gale.toml:12: environment.wind.speed = -3: must be 0 to 60 m/s");
  EXPECT_EQ(text_refusal("environment.wind.speed", "60.5"),
            "--set: environment.wind.speed = 60.5: must be 0 to 60 m/s");
  EXPECT_EQ(text_refusal("seed", "-1"), "--set: seed = -1: must be a whole number, 0 to 1000");
  EXPECT_EQ(text_refusal("sea.spectrum", "jonswop"),
            "--set: sea.spectrum = jonswop: must be pm, jonswap or tma");
  EXPECT_EQ(text_refusal("camera.target", "1,2,3000"),
            "--set: camera.target = 1,2,3000: must be 3 numbers, each -1000 to 1000 m");
  EXPECT_EQ(text_refusal("environment.date", "yesterday"),
            "--set: environment.date = yesterday: must be a date such as 2026-06-21");
}

TEST_F(Fields, RangesIncludeTheirEnds) {
  table.set_from_text("environment.wind.speed", "0", "--set");
  table.set_from_text("environment.wind.speed", "60", "--set");
  EXPECT_EQ(sea.speed, 60.0);
}

TEST_F(Fields, WrongTypesAreNamed) {
  EXPECT_EQ(
      refusal("environment.wind.speed", std::string("fast")),
      "gale.toml:12: environment.wind.speed = \"fast\": must be a number, 0 to 60 m/s, not text");
  EXPECT_EQ(refusal("sea.swell", 1.0),
            "gale.toml:12: sea.swell = 1: must be true or false, not a number");
  EXPECT_EQ(refusal("seed", true),
            "gale.toml:12: seed = true: must be a whole number, 0 to 1000, not true or false");
  EXPECT_EQ(
      refusal("boat.position", 3.0),
      "gale.toml:12: boat.position = 3: must be 2 numbers, each -1000 to 1000 m, not a number");
  EXPECT_EQ(refusal("environment.date", std::vector{1.0}),
            "gale.toml:12: environment.date = 1: must be text, not a list of numbers");
  EXPECT_EQ(refusal("sea.spectrum", 2.0),
            "gale.toml:12: sea.spectrum = 2: must be pm, jonswap or tma, not a number");
}

TEST_F(Fields, OnlyPlainFiniteNumbersAreNumbers) {
  for (const char* text :
       {"", " ", "12x", "0x10", "1e", "nan", "inf", "-inf", "1e999", "1,2", "--5", "1 2", "12\n"}) {
    EXPECT_NE(text_refusal("environment.wind.speed", text).find("must be 0 to 60 m/s"),
              std::string::npos)
        << text;
  }
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  refusal("environment.wind.speed", kNaN);
  refusal("environment.wind.speed", kInfinity);
  refusal("boat.position", std::vector{0.0, kNaN});
  for (const char* text : {"1.5", "1e10", "true", "0x1"}) text_refusal("seed", text);
  refusal("seed", 1.5);
  for (const char* text : {"1", "TRUE", "yes", ""}) text_refusal("sea.swell", text);
  for (const char* text : {"", "1", "1,2,3", "1,", ",1", "1,nan", "1;2"})
    text_refusal("boat.position", text);
}

TEST_F(Fields, AnIntegerNeverOverflows) {
  int big = 0;
  FieldTable wide;
  wide.integer("big", big, {-1e300, 1e300}, "");
  EXPECT_THROW(wide.set("big", 2147483648.0, "here"), InputError);
  EXPECT_THROW(wide.set("big", -2147483649.0, "here"), InputError);
  wide.set("big", -2147483648.0, "here");
  EXPECT_EQ(big, std::numeric_limits<int>::min());
}

TEST_F(Fields, UnknownKeysGetTheNearest) {
  EXPECT_EQ(text_refusal("environment.wnd.speed", "3"),
            "--set: environment.wnd.speed: no such key; did you mean environment.wind.speed?");
  EXPECT_EQ(text_refusal("wind.speed", "3"),
            "--set: wind.speed: no such key; did you mean environment.wind.speed?");
  EXPECT_EQ(text_refusal("sede", "3"), "--set: sede: no such key; did you mean seed?");
  EXPECT_EQ(text_refusal("qqqqqqqq", "3"),
            "--set: qqqqqqqq: no such key; --list-keys names them all");
  EXPECT_NE(text_refusal("", "3").find("no such key"), std::string::npos);
  EXPECT_NE(text_refusal(std::string(100000, 'x'), "3").find("no such key"), std::string::npos);
}

TEST_F(Fields, MessagesStayShortAndOnOneLine) {
  EXPECT_LT(text_refusal("environment.wind.speed", std::string(5000, 'x') + "\n").size(), 250u);
  EXPECT_LT(refusal("boat.position", FieldValue(std::vector<double>(9999, 1.0))).size(), 250u);
  text_refusal("sea.spectrum", "a\nb");
}

TEST_F(Fields, CheckChangesNothing) {
  table.check("environment.wind.speed", 20.0, "here");
  EXPECT_EQ(sea.speed, 8.0);
  EXPECT_THROW(table.check("environment.wind.speed", 70.0, "here"), InputError);
}

TEST_F(Fields, AKeyIsThereOnce) {
  EXPECT_THROW(table.integer("seed", sea.seed, {0, 1}, ""), Error);
  EXPECT_EQ(table.find("seed")->unit, "");
  EXPECT_EQ(table.find("nothing"), nullptr);
}

}  // namespace
}  // namespace offing
