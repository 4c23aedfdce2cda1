#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>

#include "game/render/voyage.h"
#include "support/voyage_test.h"

namespace offing {
namespace {

using SkyPlanes = test::VoyageTest;

struct Seen {
  int ran = 0, skipped = 0;  ///< times of clouds.high
  Image picture;
};

// Half of the sky, without low clouds, at noon.
Seen look(double middle, double high, double height) {
  Options options;
  options.quality = "low";
  options.fps = 30.0;
  options.sets = {"environment.time=12:00:00",
                  "environment.clouds.cover=0",
                  "camera.mode=free",
                  "camera.fov=100",
                  fmt::format("environment.clouds.high={}", high),
                  fmt::format("environment.clouds.middle={}", middle),
                  fmt::format("camera.position=0,{},0", height),
                  fmt::format("camera.target=0,{},-700", height + 900.0),
                  "boat.position=-3000,0"};
  Voyage voyage(options, {96, 54});
  voyage.next_frame();
  Seen seen;
  for (const PassReport& pass : voyage.renderer().graph().report()) {
    if (pass.name != "clouds.high") continue;
    seen.ran = pass.ran;
    seen.skipped = pass.skipped;
  }
  EXPECT_EQ(voyage.renderer().take_nonfinite_pixels(), 0u);
  seen.picture = voyage.renderer().radiance(voyage.view().light.exposure);
  return seen;
}

// Share of pixels that differ by a tenth.
double share_changed(const Image& a, const Image& b) {
  int changed = 0;
  const auto step = static_cast<std::size_t>(a.channels);
  for (std::size_t i = 0; i < a.pixels.size(); i += step) {
    changed += std::abs(a.pixels[i] / b.pixels[i] - 1.0f) > 0.1f ? 1 : 0;
  }
  return static_cast<double>(changed) / static_cast<double>(a.pixels.size() / step);
}

TEST_F(SkyPlanes, CostNothingWhereThereAreNone) {
  EXPECT_EQ(look(0.0, 0.0, 3.0).skipped, 1);
  EXPECT_EQ(look(0.3, 0.0, 3.0).ran, 1);
  EXPECT_EQ(look(0.0, 0.3, 3.0).ran, 1);
  // From above a layer is not drawn.
  EXPECT_EQ(look(0.3, 0.0, 6000.0).skipped, 1);
  EXPECT_EQ(look(0.0, 0.3, 6000.0).ran, 1);
}

TEST_F(SkyPlanes, MoreAltocumulusHidesMoreSky) {
  const Image clear = look(0.0, 0.0, 3.0).picture;
  double last = 0.01;
  for (const double middle : {0.2, 0.5, 0.9}) {
    const double hidden = share_changed(look(middle, 0.0, 3.0).picture, clear);
    EXPECT_GT(hidden, last) << middle;
    // Patches leave gaps: never more than their share by much.
    EXPECT_LT(hidden, middle + 0.15) << middle;
    last = hidden;
  }
  EXPECT_GT(last, 0.3);
}

}  // namespace
}  // namespace offing
