#include "engine/io/scene_file.h"

#include <gtest/gtest.h>

#include "engine/core/error.h"
#include "engine/io/file.h"
#include "support/scratch_folder.h"

namespace offing {
namespace {
namespace fs = std::filesystem;

struct SceneFile : testing::Test {
  SceneFile() {
    table.group("environment")
        .text("date", date, "", [](std::string_view) { return std::string(); })
        .text("time", time, "", [](std::string_view) { return std::string(); });
    table.group("environment.wind").number("speed", speed, {0, 60}, "m/s", "");
    table.group("boat").vector("position", position, {-1e4, 1e4}, "m", "");
    table.group("sea")
        .choice("spectrum", spectrum, {"pm", "jonswap", "tma"}, "")
        .flag("foam", foam, "");
    table.group("").integer("seed", seed, {0, 1e9}, "");
  }

  fs::path file() const { return folder / "gale.toml"; }
  void load(std::string_view toml) {
    write_text(file(), toml);
    load_scene(file(), table);
  }
  // What is said, without the file's name; everything must keep its value.
  std::string refusal(std::string_view toml) {
    try {
      load(toml);
    } catch (const InputError& error) {
      EXPECT_EQ(speed, 8.0);
      EXPECT_EQ(seed, 1);
      EXPECT_EQ(spectrum, 1);
      EXPECT_EQ(date, "2026-06-21");
      const std::string message = error.what();
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      EXPECT_EQ(message.find(file().string()), 0u) << message;
      return message.substr(std::min(message.size(), file().string().size()));
    }
    ADD_FAILURE() << "was not refused: " << toml;
    return "";
  }

  const test::ScratchFolder scratch;
  const fs::path folder = scratch.path();
  std::string date = "2026-06-21", time = "18:30:00";
  double speed = 8.0;
  glm::dvec2 position{0.0};
  int spectrum = 1, seed = 1;
  bool foam = true;
  FieldTable table;
};

TEST_F(SceneFile, SetsWhatItNamesAndNothingElse) {
  load(R"(seed = 42
[environment]
date = 2026-08-12
time = 07:05:00
wind.speed = 17
[boat]
position = [1, -2.5]
[sea]
foam = false
)");
  EXPECT_EQ(seed, 42);
  EXPECT_EQ(date, "2026-08-12");
  EXPECT_EQ(time, "07:05:00");
  EXPECT_EQ(speed, 17.0);
  EXPECT_EQ(position, glm::dvec2(1.0, -2.5));
  EXPECT_FALSE(foam);
  EXPECT_EQ(spectrum, 1) << "not named in the file";
}

TEST_F(SceneFile, DatesMayBeText) {
  load("[environment]\ndate = \"2027-01-02\"\n");
  EXPECT_EQ(date, "2027-01-02");
}

TEST_F(SceneFile, AnEmptyFileChangesNothing) {
  load("");
  load("# only a word\n[environment]\n");
  EXPECT_EQ(speed, 8.0);
}

TEST_F(SceneFile, SaysFileAndLine) {
  EXPECT_EQ(refusal("seed = 2\n\n[environment.wind]\nspeed = -3\n"),
            ":4: environment.wind.speed = -3: must be 0 to 60 m/s");
  EXPECT_EQ(refusal("seed = 2\n[environment]\nwnd.speed = 3\n"),
            ":3: environment.wnd.speed: no such key; did you mean environment.wind.speed?");
  EXPECT_EQ(refusal("\nsea.spectrum = \"pn\"\nseed = 3"),
            ":2: sea.spectrum = \"pn\": must be pm, jonswap or tma");
  EXPECT_EQ(refusal("seed = 1.5"), ":1: seed = 1.5: must be a whole number, 0 to 1000000000");
  EXPECT_EQ(refusal("boat.position = [1, \"two\"]"),
            ":1: boat.position: must be a list of numbers only");
  EXPECT_EQ(refusal("environment.wind.speed = nan").find(":1: environment.wind.speed = "), 0u);
  EXPECT_EQ(refusal("environment.wind.speed = inf").find(":1: environment.wind.speed = "), 0u);
  EXPECT_EQ(refusal("seed = 3\n[[sea]]\nfoam = true").find(":2: sea: "), 0u);
  EXPECT_EQ(refusal("environment.date = 2026-01-01T00:00:00Z").find(":1: environment.date: "), 0u);
}

TEST_F(SceneFile, TheFirstProblemInTheFileIsTheOneNamed) {
  EXPECT_EQ(refusal("seed = -1\nboat.position = 3\n").find(":1: seed"), 0u);
  EXPECT_EQ(refusal("boat.position = 3\nseed = -1\n").find(":1: boat.position"), 0u);
}

TEST_F(SceneFile, BadTomlSaysWhere) {
  EXPECT_EQ(refusal("seed = 1\nseed = 2\n").find(":2: not TOML: "), 0u);
  EXPECT_EQ(refusal("seed = \n").find(":1: not TOML: "), 0u);
  EXPECT_EQ(refusal("seed = 3\n[environment\n").find(":2: not TOML: "), 0u);
  EXPECT_EQ(refusal("seed = \"\xff\xfe\"").find(":1: not TOML: "), 0u);
  EXPECT_EQ(refusal(std::string("seed = 3\n\0", 10)).find(":2: not TOML: "), 0u);
  EXPECT_EQ(refusal("a = " + std::string(100000, '[')).find(":1: not TOML: "), 0u);
}

TEST_F(SceneFile, MissingFileIsNamed) {
  EXPECT_THROW(load_scene(folder / "none.toml", table), InputError);
  EXPECT_THROW(load_scene(folder, table), InputError);
}

TEST_F(SceneFile, IsFoundByNameOrPath) {
  write_text(folder / "gale.toml", "");
  write_text(folder / "calm.toml", "");
  write_text(folder / "README.md", "");
  EXPECT_EQ(find_scene("gale", folder), folder / "gale.toml");
  EXPECT_EQ(find_scene((folder / "calm.toml").string(), "elsewhere"), folder / "calm.toml");
  const auto said = [&](std::string_view name) {
    try {
      find_scene(name, folder);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("found");
  };
  EXPECT_EQ(said("gael"),
            "--scene gael: no such scene; there are calm, gale, or give a .toml file");
  EXPECT_NE(said("no.toml"), "found");
  EXPECT_NE(said(folder.string() + "/"), "found");
  EXPECT_NE(said(""), "found");
}

}  // namespace
}  // namespace offing
