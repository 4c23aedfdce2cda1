#include "engine/sky/sky.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "engine/core/angles.h"
#include "engine/environment/calendar.h"
#include "support/sky_graph_test.h"

#define OFFING_GLSL "shaders/lib/phase.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/scattering.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

constexpr int kWidth = 160, kHeight = 90;

class SkyTest : public test::SkyGraphTest {
 protected:
  void SetUp() override {
    SkyGraphTest::SetUp();
    if (IsSkipped()) return;
    make_picture(GL_RGBA16F, kWidth, kHeight);
  }

  /// One frame toward a direction; the picture's pixels, bottom row first.
  std::vector<float> draw(const CelestialState& celestial, double azimuth_deg, double pitch_deg,
                          double fov_deg, double haze = 0.1) {
    light_ = model_.update(celestial, haze, 3.0);
    const shared::FrameData frame =
        test::camera_toward(test::toward(azimuth_deg, pitch_deg), fov_deg, kWidth, kHeight);
    const float nothing[4] = {0, 0, 0, 0};
    glClearTexImage(hdr_.id(), 0, GL_RGBA, GL_FLOAT, nothing);
    glClearTexImage(depth_.id(), 0, GL_DEPTH_COMPONENT, GL_FLOAT, nothing);
    const SkyIds ids = begin_frame(frame, light_);
    const TextureId hdr = graph_->import(hdr_);
    sky_->add_background(*graph_, light_, ids, hdr, graph_->import(depth_),
                         sky_in_view(frame.relative_from_clip, 3.0));
    graph_->add(
        "show", [&](PassBuilder& pass) { pass.read(hdr).side_effect(); }, [](PassContext&) {});
    graph_->execute();
    return hdr_.read_floats(4);
  }

  static glm::dvec3 pixel(const std::vector<float>& picture, int x, int y) {
    const auto i = static_cast<std::size_t>(4 * (y * kWidth + x));
    return {picture[i], picture[i + 1], picture[i + 2]};
  }
};

using test::sun_at;

TEST_F(SkyTest, TransmittanceTableHoldsTheIntegral) {
  light_ = model_.update(sun_at(90.0, 30.0), 0.0, 3.0);
  graph_->begin_frame();
  const SkyIds ids = sky_->add_tables(*graph_, light_);
  std::vector<float> table;
  graph_->add(
      "read", [&](PassBuilder& pass) { pass.read(ids.transmittance).side_effect(); },
      [&](PassContext& context) { table = context.texture(ids.transmittance).read_floats(4); });
  graph_->execute();
  const glsl::Aerosol aerosol = glsl::aerosol_of_haze(0.0);
  int checked = 0;
  for (int y = 0; y < 64; y += 7) {
    for (int x = 0; x < 256; x += 15) {
      const glsl::HeightCosine place = glsl::transmittance_place({x / 255.0, y / 63.0});
      const glsl::vec3 exact =
          glsl::transmittance_to_top(aerosol, place.height, place.cosine, 1500);
      for (int c = 0; c < 3; ++c) {
        const double seen = table[static_cast<std::size_t>(4 * (y * 256 + x) + c)];
        if (exact[c] > 0.01) {
          EXPECT_NEAR(seen / exact[c], 1.0, 0.01) << place.height << " " << place.cosine;
          ++checked;
        } else {
          EXPECT_NEAR(seen, exact[c], 1e-3);
        }
      }
    }
  }
  EXPECT_GT(checked, 400);
}

TEST_F(SkyTest, TheSunIsWhereItsDirectionSays) {
  for (double azimuth : {60.0, 250.0}) {
    const std::vector<float> picture = draw(sun_at(azimuth, 35.0), azimuth, 35.0, 4.0);
    glm::dvec2 sum(0.0);
    double weight = 0.0;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        if (pixel(picture, x, y).y < 1000.0) continue;
        sum += glm::dvec2(x + 0.5, y + 0.5);
        weight += 1.0;
      }
    }
    ASSERT_GT(weight, 0.0);
    EXPECT_NEAR(sum.x / weight, kWidth / 2.0, 0.5);
    EXPECT_NEAR(sum.y / weight, kHeight / 2.0, 0.5);
    const double across = 2.0 * 0.25 / 4.0 * kWidth;  // pixels
    EXPECT_NEAR(weight, kPi / 4.0 * across * across, 0.1 * across * across);
  }
  // A little to the left of the sun, it must show to the right of the middle.
  const std::vector<float> left = draw(sun_at(90.0, 35.0), 88.9, 35.0, 4.0);
  EXPECT_LT(pixel(left, kWidth / 4, kHeight / 2).y, 1000.0);
  double right_half = 0.0;
  for (int x = kWidth / 2; x < kWidth; ++x)
    right_half = std::max(right_half, pixel(left, x, kHeight / 2).y);
  EXPECT_GT(right_half, 1000.0);
}

TEST_F(SkyTest, ATurningSunGivesFinitePositiveLight) {
  // 24 hours, with a moon, at a place where both rise and set; toward the sun and away from it.
  for (int hour = 0; hour < 24; ++hour) {
    const double utc = *parse_date("2026-08-25") + 3600.0 * hour;
    const CelestialState s = celestial_state(utc, 43.0, -8.0);
    const std::vector<float> picture = draw(s, s.sun.azimuth_deg + 30.0 * (hour % 3), 10.0, 100.0);
    for (std::size_t i = 0; i < picture.size(); ++i) {
      ASSERT_TRUE(std::isfinite(picture[i]) && picture[i] >= 0.0f) << hour << " " << i;
    }
    for (int y : {0, kHeight / 2, kHeight - 1}) {
      EXPECT_GT(pixel(picture, kWidth / 3, y).y, 0.0) << hour << " row " << y;
    }
  }
}

TEST_F(SkyTest, NothingIsComputedTwiceWhileTheClockStands) {
  const CelestialState s = sun_at(200.0, 25.0);
  for (int frame = 0; frame < 5; ++frame) draw(s, 200.0, 10.0, 60.0);
  for (const char* name : {"sky.transmittance", "sky.multiscatter", "sky.sun_view", "sky.block"}) {
    EXPECT_EQ(row(name).ran, 1) << name;
    EXPECT_EQ(row(name).cached, 4) << name;
  }
  EXPECT_EQ(row("sky.moon_view").skipped, 5);
  EXPECT_EQ(row("sky.stars").skipped, 5);

  draw(sun_at(210.0, 25.0), 200.0, 10.0, 60.0);  // the azimuth alone costs no table
  EXPECT_EQ(row("sky.sun_view").ran, 1);
  draw(sun_at(210.0, 25.1), 200.0, 10.0, 60.0);
  EXPECT_EQ(row("sky.sun_view").ran, 2);
  EXPECT_EQ(row("sky.multiscatter").ran, 1);
  draw(sun_at(210.0, 25.1), 200.0, 10.0, 60.0, 0.4);  // another air: everything
  EXPECT_EQ(row("sky.transmittance").ran, 2);
  EXPECT_EQ(row("sky.multiscatter").ran, 2);
  EXPECT_EQ(row("sky.sun_view").ran, 3);
}

TEST_F(SkyTest, LookingDownSkipsTheSky) {
  draw(sun_at(200.0, 25.0), 0.0, -60.0, 50.0);
  EXPECT_EQ(row("sky.background").skipped, 1);
  EXPECT_EQ(row("sky.sun_view").culled, 1);
  draw(sun_at(200.0, 25.0), 0.0, -10.0, 50.0);
  EXPECT_EQ(row("sky.background").ran, 1);
}

TEST_F(SkyTest, TheSkyIsBrighterThanItsFirstOrderAlone) {
  // Compare the middle of a narrow picture
  // with a direct integration in double along the same ray.
  for (double elevation : {40.0, 5.0}) {
    const std::vector<float> picture = draw(sun_at(180.0, elevation), 300.0, 30.0, 2.0);
    const double seen = pixel(picture, kWidth / 2, kHeight / 2).z / light_.exposure;
    // Single scattering alone, in double, of the blue band: the sky must be brighter than that (its
    // higher orders add up to as much again) but not three times as bright.
    const glsl::Aerosol aerosol = glsl::aerosol_of_haze(0.1);
    const double cosine = std::sin(radians(30.0)), sun = std::sin(radians(elevation));
    const double towards = cosine * sun + std::sqrt((1 - cosine * cosine) * (1 - sun * sun)) *
                                              std::cos(radians(120.0));
    const double along = glsl::distance_to_top(0.003, cosine);
    double single = 0.0, depth = 0.0;
    constexpr int kSteps = 400;
    for (int i = 0; i < kSteps; ++i) {
      const double d = along * (i + 0.5) / kSteps, dt = along / kSteps;
      const double h = glsl::height_along(0.003, cosine, d);
      const glsl::Air air = glsl::air_at(aerosol, h);
      const double c = glsl::cosine_along(0.003, sun, towards, d, h);
      depth += air.extinction.z * dt;
      single += std::exp(-depth) * glsl::transmittance_to_top(aerosol, h, c, 64).z * dt *
                (air.rayleigh.z * glsl::rayleigh_phase(towards) +
                 air.mie.z * glsl::cornette_shanks(glsl::kMieG, towards));
    }
    single *= light_.sun_source.z;
    EXPECT_GT(seen, 1.05 * single) << elevation;
    EXPECT_LT(seen, 3.0 * single) << elevation;
  }
}

}  // namespace
}  // namespace offing
