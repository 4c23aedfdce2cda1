// Boat files: R8's own, and files with impossible numbers.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "engine/boat/boat.h"
#include "engine/core/error.h"
#include "engine/core/paths.h"
#include "support/scratch_folder.h"

namespace offing {
namespace {
namespace fs = std::filesystem;

class BoatFile : public testing::Test {
 protected:
  fs::path write(const std::string& text) const {
    std::ofstream(folder_ / "boat.toml") << text;
    return folder_ / "boat.toml";
  }
  /// The message of a file that must be refused.
  std::string complaint(const std::string& text) const {
    try {
      load_boat(write(text));
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing";
  }

  const test::ScratchFolder scratch_;
  const fs::path folder_ = scratch_.path();
};

TEST_F(BoatFile, R8sFileSaysWhatTheCodeSays) {
  R8Parameters from_file = load_boat(data_root() / "assets/boats/r8.toml"), built_in;
  FieldTable a, b;
  describe(a, from_file);
  describe(b, built_in);
  ASSERT_EQ(a.fields().size(), b.fields().size());
  for (std::size_t i = 0; i < a.fields().size(); ++i) {
    EXPECT_EQ(FieldTable::to_text(a.fields()[i]), FieldTable::to_text(b.fields()[i]))
        << a.fields()[i].key;
  }
}

TEST_F(BoatFile, WhatIsLeftOutIsR8s) {
  const R8Parameters p = load_boat(write("mass = 2100.0\n[rig]\nmain_area = 22\n"));
  EXPECT_EQ(p.mass, 2100.0);
  EXPECT_EQ(p.rig.main_area, 22.0);
  EXPECT_EQ(p.rig.jib_area, R8Parameters{}.rig.jib_area);
}

TEST_F(BoatFile, ImpossibleNumbersAreNamedWithFileLineAndField) {
  const struct {
    const char *text, *place, *field;
  } kRows[] = {
      {"# a boat\nmass = -5\n", "boat.toml:2: ", "mass = -5"},
      {"mass = 0\n", "boat.toml:1: ", "mass"},
      {"mass = nan\n", "boat.toml:1: ", "mass"},
      {"mass = \"heavy\"\n", "boat.toml:1: ", "mass"},
      {"\ncentre_of_gravity = [0, 6.0, 0]\n", "boat.toml:2: ", "centre_of_gravity"},
      {"centre_of_gravity = [0, -3.0, 0]\n", "boat.toml:1: ", "centre_of_gravity"},
      {"centre_of_gravity = [2.0, 0, 0]\n", "boat.toml:1: ", "centre_of_gravity"},
      {"centre_of_gravity = [0, 0, 4.5]\n", "boat.toml:1: ", "centre_of_gravity"},
      {"[rig]\nmain_area = 20\nmast_top = 0\n", "boat.toml:3: ", "rig.mast_top = 0"},
      {"[rig]\nmain_area = -1\n", "boat.toml:2: ", "rig.main_area"},
      {"mass = 90000\n", "boat.toml:1: ", "mass = 90000"},
      {"[lines]\nbeam = 1.0\n", "boat.toml:2: ", "lines.beam"},
      {"[crew]\nmass = 1900\n", "boat.toml:2: ", "crew.mass"},
      {"mas = 3\n", "boat.toml:1: ", "mass"},
      {"mass = \n", "boat.toml:1: ", "TOML"},
  };
  for (const auto& row : kRows) {
    const std::string message = complaint(row.text);
    EXPECT_NE(message.find(row.place), std::string::npos) << row.text << " gave " << message;
    EXPECT_NE(message.find(row.field), std::string::npos) << row.text << " gave " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST_F(BoatFile, AnotherBoatFloats) {
  // Half again as heavy on the same lines, no sails and no mast: a motor boat, deep in the water.
  const R8Parameters p =
      load_boat(write("mass = 2900\n[rig]\nmain_area = 0\njib_area = 0\nmast_top = 0\n"));
  Boat boat(p);
  const CalmWater water;
  const SteadyWind wind(6.0, 0.0);
  boat.controls().motor = 1.0;
  boat.start({0.0, 0.0}, 0.0, 0.0, water, 0.0);
  EXPECT_LT(boat.state().position.y, -0.05);
  for (int i = 0; i < 30 * 60; ++i) boat.step(water, wind, i / 60.0, 1.0 / 60.0);
  EXPECT_GT(boat.navigation().stw, 1.0);
  EXPECT_EQ(boat.limit_hits(), 0);
}

}  // namespace
}  // namespace offing
