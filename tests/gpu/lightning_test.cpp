// Lightning in whole pictures, against the same voyage without it.
#include "engine/clouds/lightning.h"

#include <gtest/gtest.h>

#include <fmt/core.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "engine/core/angles.h"
#include "game/render/voyage.h"
#include "support/voyage_test.h"

namespace offing {
namespace {

constexpr glm::ivec2 kSize{64, 36};

using LightningPicture = test::VoyageTest;

constexpr int kFrames = 8;

// A moonless night among storms, seen from the sea with no boat near.
Voyage stormy(const char* rate, const glm::dvec3& toward) {
  const glm::dvec3 target = glm::dvec3(-15000.0, 4.0, -4000.0) + 1000.0 * toward;
  Options options;
  options.quality = "low";
  options.fps = 4.0;
  options.seed = 6;  // a flash within the first two seconds
  options.sets = {"environment.date=2026-08-13",
                  "environment.time=23:00:00",
                  "environment.clouds.cover=0.6",
                  "environment.clouds.precipitation=0.8",
                  "environment.clouds.type=1",
                  "boat.position=-3000,0",
                  "camera.mode=free",
                  "camera.position=-15000,4,-4000",  // eight kilometres off a storm
                  "camera.fov=90",
                  "clouds.rain_rate=0",  // the glow itself, not through rain
                  fmt::format("camera.target={},{},{}", target.x, target.y, target.z),
                  fmt::format("clouds.lightning={}", rate)};
  return {options, kSize};
}

struct Light {
  double above = 0.0, below = 0.0;  // from above and below the horizon on a surface facing it, lux
};

// Of the picture: the sum over its pixels of luminance and solid angle, each by its cosine.
Light light_of(Voyage& voyage) {
  const Image picture = voyage.renderer().radiance(voyage.view().light.exposure);
  const glm::dmat4 relative_from_clip(voyage.view().frame.relative_from_clip);
  const glm::dvec4 middle = relative_from_clip * glm::dvec4(0.0, 0.0, 1.0, 1.0);
  const glm::dvec3 ahead = glm::normalize(glm::dvec3(middle) / middle.w);
  const double pixel = voyage.view().frame.camera.w;  // its side one unit before the eye
  Light light;
  for (int y = 0; y < kSize.y; ++y) {
    for (int x = 0; x < kSize.x; ++x) {
      const glm::dvec4 at = relative_from_clip * glm::dvec4(2.0 * (x + 0.5) / kSize.x - 1.0,
                                                            1.0 - 2.0 * (y + 0.5) / kSize.y, 1, 1);
      const glm::dvec3 direction = glm::normalize(glm::dvec3(at) / at.w);
      const double cosine = glm::dot(direction, ahead);
      const auto* c =
          &picture.pixels[static_cast<std::size_t>((y * kSize.x + x) * picture.channels)];
      const double luminance = 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
      (direction.y > 0.0 ? light.above : light.below) +=
          luminance * pixel * pixel * std::pow(cosine, 4.0);
    }
  }
  return light;
}

TEST_F(LightningPicture, LightsTheSeaAsMuchAsItsCloudGlows) {
  // Which frame is brightest, and where the flash stands in it.
  int brightest = 0;
  glm::dvec3 toward(0.0, 0.0, -1.0);
  double lux = 0.0;
  {
    Voyage voyage = stormy("60", toward);
    for (int i = 0; i < kFrames; ++i) {
      voyage.next_frame();
      const shared::FrameData& frame = voyage.view().frame;
      if (frame.flash_illuminance.y <= lux) continue;
      lux = frame.flash_illuminance.y;
      brightest = i;
      toward = glm::dvec3(frame.flash_direction);
    }
  }
  ASSERT_GT(lux, 0.05);
  // Before it, with the horizon in view.
  toward = glm::normalize(glm::dvec3(toward.x, 0.6 * toward.y, toward.z));
  Light added[2];
  for (const int lit : {0, 1}) {
    Voyage voyage = stormy(lit ? "60" : "0", toward);
    for (int i = 0; i <= brightest; ++i) voyage.next_frame();
    added[lit] = light_of(voyage);
    EXPECT_EQ(voyage.view().frame.flash_illuminance.y > 0.0f, lit == 1);
    EXPECT_EQ(voyage.renderer().take_nonfinite_pixels(), 0u);
    for (const auto& message : voyage.debug().messages()) ADD_FAILURE() << message.text;
  }
  const double glow = added[1].above - added[0].above, mirrored = added[1].below - added[0].below;
  // Much of the glow is hidden behind other clouds, but there is not more of it than the flash
  // gives.
  EXPECT_GT(glow, 0.03 * lux);
  EXPECT_LT(glow, 2.0 * lux);
  // The view of the sea is about a steradian, and of what falls on it some hundredths come back.
  EXPECT_GT(mirrored, 0.01 * lux / kPi);
  EXPECT_LT(mirrored, 0.5 * lux / kPi);
  EXPECT_GT(mirrored, 10.0 * added[0].below) << "by night it is all that the sea shows";
}

}  // namespace
}  // namespace offing
