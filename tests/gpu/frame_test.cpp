// The whole frame through the game's own path: what runs, and what does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "game/render/voyage.h"
#include "support/voyage_test.h"

namespace offing {
namespace {

class Frame : public test::VoyageTest {
 protected:
  // Draws `frames` small pictures of the default scene with these settings, after one that fills
  // what is kept.
  void sail(std::vector<std::string> settings, int frames) {
    Options options;
    options.quality = "low";
    options.fps = 30.0;
    options.sets = std::move(settings);
    voyage_.emplace(options, glm::ivec2(96, 54));
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
  sail({"sea.queries=readback"}, 3);
  for (const char* name :
       {"sea.fft", "sea.maps", "sea.mesh", "sea.draw", "boat", "sky.background", "post.tonemap"}) {
    EXPECT_EQ(row(name).ran, 3) << name;
  }
  EXPECT_GE(row("sea.readback").ran, 1) << "a moment of the waves each 1/8 s";
  EXPECT_EQ(row("sea.spectrum").cached, 3);
  EXPECT_EQ(row("sky.transmittance").cached, 3);
  EXPECT_EQ(row("sky.moon_view").skipped, 3) << "no moonlight by day";
}

TEST_F(Frame, PausedTimeTransformsNothing) {
  sail({"environment.paused=true", "sea.queries=readback"}, 3);
  for (const char* name : {"sea.spectrum", "sea.fft", "sea.maps", "sky.transmittance",
                           "sky.multiscatter", "sky.sun_view"}) {
    EXPECT_EQ(row(name).cached, 3) << name;
    EXPECT_EQ(row(name).ran, 0) << name;
  }
  EXPECT_EQ(row("sea.draw").ran, 3);
  // Within a few frames all the moments that queries will ask for have come back.
  for (int i = 0; i < 6; ++i) voyage_->next_frame();
  voyage_->reset_measures();
  for (int i = 0; i < 2; ++i) voyage_->next_frame();
  EXPECT_EQ(row("sea.readback").ran, 0);
}

TEST_F(Frame, NoSeaIsDrawnForAnEyeThatLooksUp) {
  auto settings = looking("500,3,500", "500.1,500,500");
  settings.emplace_back("environment.paused=true");
  sail(settings, 3);
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
  EXPECT_EQ(row("sky.background").skipped, 3);
  EXPECT_EQ(row("sky.stars").skipped, 3);
  EXPECT_EQ(row("sea.draw").ran, 3);
}

constexpr const char* kWetPasses[] = {"frame.solid", "sea.split", "sea.caustics", "sea.relight",
                                      "sea.underwater"};

TEST_F(Frame, WaterCostsNothingWhileTheLensIsDry) {
  // A metre above a sea of .3 m, and from a mast's height over the usual one.
  for (const bool low : {true, false}) {
    voyage_.reset();
    auto settings = looking(low ? "500,1,500" : "500,9,500", "600,0,500");
    if (low) {
      settings.insert(settings.end(), {"environment.wind.speed=5", "sea.swell.height=0"});
    }
    sail(settings, 2);
    for (const char* name : kWetPasses) EXPECT_EQ(row(name).skipped, 2) << name << " low: " << low;
    EXPECT_EQ(row("sea.draw").ran, 2);
  }
}

TEST_F(Frame, SprayFliesInAGaleAndCostsNothingInABreeze) {
  sail({"environment.wind.speed=9"}, 3);
  EXPECT_EQ(row("sea.spray").skipped, 3);
  sail({"environment.wind.speed=22"}, 12);
  EXPECT_EQ(row("sea.spray").ran, 12);
  const Spray& spray = voyage_->renderer().ocean().spray();
  std::vector<float> drops(8 * static_cast<std::size_t>(spray.count()));
  spray.drops().read(drops.data(), drops.size() * sizeof(float));
  int flying = 0;
  double downwind = 0.0;
  for (std::size_t i = 0; i < drops.size(); i += 8) {
    for (std::size_t j = 0; j < 8; ++j) ASSERT_TRUE(std::isfinite(drops[i + j]));
    if (drops[i + 7] <= 0.0f) continue;
    ++flying;
    EXPECT_LT(std::hypot(drops[i], drops[i + 2]), 300.0f);  // born within 180 m and carried on
    EXPECT_GT(drops[i + 1], -15.0f);
    EXPECT_LT(drops[i + 1], 25.0f);
    downwind += static_cast<double>(std::hypot(drops[i + 4], drops[i + 6]));
  }
  EXPECT_GT(flying, spray.count() / 50);
  EXPECT_LT(flying, spray.count());
  EXPECT_GT(downwind / flying, 0.3 * 22.0);  // m/s
}

TEST_F(Frame, UnderWaterNothingIsDrawnOfTheAir) {
  sail(looking("9,-3,6", "0,0,0"), 2);
  for (const char* name : {"sea.draw", "sky.background", "sea.split"}) {
    EXPECT_EQ(row(name).skipped, 2) << name;
  }
  for (const char* name : {"sea.mesh", "sea.caustics", "sea.relight", "sea.underwater"}) {
    EXPECT_EQ(row(name).ran, 2) << name;
  }
}

// sail() itself looks for messages of the driver and for pixels that are not finite.
TEST_F(Frame, ALensMayCrossTheSurface) {
  for (const char* scene : {"environment.wind.speed=3", "environment.wind.speed=22"}) {
    voyage_.reset();
    auto settings = looking("7,0,5", "0,0.3,0");
    settings.emplace_back(scene);
    sail(settings, 2);
    EXPECT_EQ(row("sea.underwater").ran, 2) << scene;
    EXPECT_EQ(row("sea.underwater").skipped, 0) << scene;
  }
}

// Light is neither made nor lost by waves: what they gather in one place is missing in another.
// Away from the edges, where rays come and go, the mean is 1 but for what steep facets reflect.
TEST_F(Frame, CloudsAreSeenThroughTheWaterAndMirroredByIt) {
  // Up through Snell's window, and down at a nearly calm sea: an overcast takes the blue out of
  // both.
  for (const auto& [from, at] :
       {std::pair("500,-5,500", "500.1,5,500"), {"500,30,500", "540,0,500"}}) {
    double blue[2];  // over red
    for (const bool cloudy : {false, true}) {
      voyage_.reset();
      auto settings = looking(from, at);
      for (const char* more : {"environment.wind.speed=1", "sea.swell.height=0",
                               "environment.paused=true", "environment.clouds.type=0.5"}) {
        settings.emplace_back(more);
      }
      settings.emplace_back(cloudy ? "environment.clouds.cover=1" : "environment.clouds.cover=0");
      sail(settings, 1);
      const Image picture = voyage_->renderer().radiance(1.0);
      double sums[3] = {0.0, 0.0, 0.0};
      for (std::size_t i = 0; i < picture.pixels.size(); ++i) sums[i % 3] += picture.pixels[i];
      blue[cloudy ? 1 : 0] = sums[2] / sums[0];
    }
    EXPECT_LT(blue[1], 0.85 * blue[0]) << from;
  }
}

TEST_F(Frame, WavesGatherLightAndMakeNone) {
  // Waves of a metre or two: a part of a longer one would be a slope that faces the sun or not.
  auto settings = looking("500,-2,500", "600,-2,500");
  settings.insert(settings.end(),
                  {"environment.wind.speed=3", "sea.fetch=1", "sea.swell.height=0"});
  sail(settings, 1);
  const gl::Texture& map = voyage_->renderer().ocean().underwater().caustics();
  const std::vector<float> values = map.read_floats(1);
  const auto n = static_cast<std::size_t>(map.width());
  const std::size_t edge = n / 4;
  for (std::size_t layer = 0; layer < values.size() / (n * n); ++layer) {
    double sum = 0.0, square = 0.0, count = 0.0;
    for (std::size_t y = edge; y < n - edge; ++y) {
      for (std::size_t x = edge; x < n - edge; ++x) {
        const double value = static_cast<double>(values[(layer * n + y) * n + x]);
        ASSERT_TRUE(std::isfinite(value) && value >= 0.0);
        sum += value;
        square += value * value;
        count += 1.0;
      }
    }
    // Over ten metres: at 9 m depth rays end up to .3 m aside, at random along the border.
    EXPECT_NEAR(sum / count, 1.0, 0.04) << "layer " << layer;
    EXPECT_GT(square / count - (sum / count) * (sum / count), 1e-3) << "layer " << layer;
  }
}

TEST_F(Frame, AFlatSeaGathersNothing) {
  auto settings = looking("500,-2,500", "600,-2,500");
  settings.emplace_back("environment.wind.speed=0");
  settings.emplace_back("sea.swell.height=0");
  sail(settings, 1);
  const gl::Texture& map = voyage_->renderer().ocean().underwater().caustics();
  const std::vector<float> values = map.read_floats(1);
  const auto n = static_cast<std::size_t>(map.width());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t x = i % n, y = i / n % n;
    if (x < 2 || y < 2 || x + 2 >= n || y + 2 >= n) continue;
    // Sums of whole 1/4096ths, sixteen to a texel, as half floats.
    ASSERT_NEAR(static_cast<double>(values[i]), 1.0, 3e-3) << x << " " << y;
  }
}

TEST_F(Frame, TheSameVoyageGivesTheSamePicture) {
  Image first;
  for (int run = 0; run < 2; ++run) {
    voyage_.reset();  // one context at a time
    sail({}, 4);
    const Image picture = voyage_->renderer().picture();
    if (run == 0) first = picture;
    EXPECT_EQ(picture.pixels, first.pixels);
  }
}

// Against the integral of the spectrum, through everything between them. One snapshot of one sea
// scatters by some 10 %; its cascades are large enough for that.
TEST_F(Frame, TheSeaThatIsDrawnHasTheHeightOfItsSpectrum) {
  sail({"environment.wind.speed=12", "sea.swell.height=0"}, 1);
  const SeaMeasurement measured = voyage_->renderer().measure_sea();
  const SeaStatistics expected = voyage_->renderer().ocean().statistics();
  EXPECT_NEAR(measured.hs / expected.hs, 1.0, 0.1);
  EXPECT_NEAR(measured.tp / expected.tp, 1.0, 0.15);
}

}  // namespace
}  // namespace offing
