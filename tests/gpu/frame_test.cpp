// The whole frame through the game's own path: what runs, and what does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/core/error.h"
#include "game/render/voyage.h"

namespace offing {
namespace {

class Frame : public ::testing::Test {
 protected:
  // Draws `frames` small pictures of the default scene with these settings, after one that fills
  // what is kept.
  void sail(std::vector<std::string> settings, int frames) {
    Options options;
    options.quality = "low";
    options.fps = 30.0;
    options.sets = std::move(settings);
    try {
      voyage_.emplace(options, glm::ivec2(96, 54));
    } catch (const InputError& error) {
      if (std::string(error.what()).find("OpenGL") == std::string::npos) throw;
      GTEST_SKIP() << error.what();
    }
    voyage_->next_frame();
    voyage_->reset_measures();
    for (int i = 0; i < frames; ++i) voyage_->next_frame();
    for (const auto& message : voyage_->debug().messages()) ADD_FAILURE() << message.text;
    EXPECT_EQ(voyage_->renderer().take_nonfinite_pixels(), 0u);
  }

  PassReport row(const std::string& name) {
    const auto& rows = voyage_->renderer().graph().report();
    const auto found = std::find_if(rows.begin(), rows.end(),
                                    [&](const PassReport& report) { return report.name == name; });
    if (found == rows.end()) ADD_FAILURE() << "no pass " << name;
    return found == rows.end() ? PassReport{} : *found;
  }

  // A camera of its own: where it stands and what it looks at.
  static std::vector<std::string> looking(const std::string& from, const std::string& at) {
    return {"camera.mode=free", "camera.position=" + from, "camera.target=" + at};
  }

  std::optional<Voyage> voyage_;
};

TEST_F(Frame, EverythingRunsWhileTimeDoes) {
  sail({}, 3);
  if (!voyage_) return;
  for (const char* name : {"sea.fft", "sea.maps", "sea.readback", "sea.mesh", "sea.draw", "boat",
                           "sky.background", "post.tonemap"}) {
    EXPECT_EQ(row(name).ran, 3) << name;
  }
  EXPECT_EQ(row("sea.spectrum").cached, 3);
  EXPECT_EQ(row("sky.transmittance").cached, 3);
  EXPECT_EQ(row("sky.moon_view").skipped, 3) << "no moonlight by day";
}

TEST_F(Frame, PausedTimeTransformsNothing) {
  sail({"environment.paused=true"}, 3);
  if (!voyage_) return;
  for (const char* name : {"sea.spectrum", "sea.fft", "sea.maps", "sky.transmittance",
                           "sky.multiscatter", "sky.sun_view"}) {
    EXPECT_EQ(row(name).cached, 3) << name;
    EXPECT_EQ(row(name).ran, 0) << name;
  }
  EXPECT_EQ(row("sea.readback").ran, 0) << "this moment has come back already";
  EXPECT_EQ(row("sea.draw").ran, 3);
}

TEST_F(Frame, NoSeaIsDrawnForAnEyeThatLooksUp) {
  auto settings = looking("500,3,500", "500.1,500,500");
  settings.emplace_back("environment.paused=true");
  sail(settings, 3);
  if (!voyage_) return;
  EXPECT_EQ(row("sea.mesh").skipped, 3);
  EXPECT_EQ(row("sea.draw").skipped, 3);
  EXPECT_EQ(row("boat").skipped, 3) << "she lies at the origin";
  // With nothing to float on anew and nothing to draw, nobody reads the maps or the mask.
  EXPECT_EQ(row("sea.fft").culled, 3);
  EXPECT_EQ(row("sea.maps").culled, 3);
  EXPECT_EQ(row("boat.mask").culled, 3);
  EXPECT_EQ(row("sky.background").ran, 3);
}

TEST_F(Frame, NoSkyIsDrawnForAnEyeThatLooksDown) {
  sail(looking("500,30,500", "500.1,-500,500"), 3);
  if (!voyage_) return;
  EXPECT_EQ(row("sky.background").skipped, 3);
  EXPECT_EQ(row("sky.stars").skipped, 3);
  EXPECT_EQ(row("sea.draw").ran, 3);
}

TEST_F(Frame, TheSameVoyageGivesTheSamePicture) {
  Image first;
  for (int run = 0; run < 2; ++run) {
    voyage_.reset();  // one context at a time
    sail({}, 4);
    if (!voyage_) return;
    const Image picture = voyage_->renderer().picture();
    if (run == 0) first = picture;
    EXPECT_EQ(picture.pixels, first.pixels);
  }
}

// Against the integral of the spectrum, through everything between them. One snapshot of one sea
// scatters by some 10 %; its cascades are large enough for that.
TEST_F(Frame, TheSeaThatIsDrawnHasTheHeightOfItsSpectrum) {
  sail({"environment.wind.speed=12", "sea.swell.height=0"}, 1);
  if (!voyage_) return;
  const SeaMeasurement measured = voyage_->renderer().measure_sea();
  const SeaStatistics expected = voyage_->renderer().ocean().statistics();
  EXPECT_NEAR(measured.hs / expected.hs, 1.0, 0.1);
  EXPECT_NEAR(measured.tp / expected.tp, 1.0, 0.15);
}

}  // namespace
}  // namespace offing
