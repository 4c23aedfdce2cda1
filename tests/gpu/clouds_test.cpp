#include "engine/clouds/clouds.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "engine/core/angles.h"
#include "shaders/shared/frame.h"
#include "support/sky_graph_test.h"

#define OFFING_GLSL "shaders/lib/clouds.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

constexpr int kWidth = 96, kHeight = 54;

class CloudsTest : public test::SkyGraphTest {
 protected:
  void SetUp() override {
    SkyGraphTest::SetUp();
    if (IsSkipped()) return;
    clouds_ = std::make_unique<Cloudscape>(*shaders_, 0);
    make_picture(GL_RGBA16F, kWidth, kHeight);
    view_.eye = {0.0, 3.0, 0.0};
    view_.elapsed = 100.0;
  }

  void TearDown() override {
    clouds_.reset();
    SkyGraphTest::TearDown();
  }

  /// One frame toward a direction, with nothing but clouds over black; the pixels, bottom row
  /// first.
  std::vector<float> draw(double azimuth_deg, double pitch_deg, double fov_deg = 70.0) {
    const SkyLight& light = model_.update(sun_, 0.1, view_.eye.y);
    const shared::FrameData frame = test::camera_toward(test::toward(azimuth_deg, pitch_deg),
                                                        fov_deg, kWidth, kHeight, view_.eye.y);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    const float behind[4] = {background_, background_, background_, 1};
    glClearTexImage(hdr_.id(), 0, GL_RGBA, GL_FLOAT, behind);
    const float nothing[4] = {0, 0, 0, 0}, near = 0.05f;
    glClearTexImage(depth_.id(), 0, GL_DEPTH_COMPONENT, GL_FLOAT, nothing);
    if (mast_ >= 0) {
      glClearTexSubImage(depth_.id(), 0, mast_, 0, 0, kMastWidth, kHeight, 1, GL_DEPTH_COMPONENT,
                         GL_FLOAT, &near);
    }
    const SkyIds sky = begin_frame(frame, light);
    const CloudscapeIds clouds = clouds_->add_field(*graph_, view_, light);
    const TextureId hdr = graph_->import(hdr_);
    const CloudCamera camera{
        {kWidth, kHeight}, frame.clip_from_relative, view_.eye, light.exposure};
    clouds_->add_picture(*graph_, clouds, view_, camera, *sky_, sky, hdr, graph_->import(depth_),
                         sky_in_view(frame.relative_from_clip, view_.eye.y));
    graph_->add(
        "show", [&](PassBuilder& pass) { pass.read(hdr).side_effect(); }, [](PassContext&) {});
    graph_->execute();
    return hdr_.read_floats(4);
  }

  /// By a display of 255 steps with a simple curve.
  static double shown(float light) { return 255.0 * std::pow(light / (1.0 + light), 1.0 / 2.2); }
  static double mean(const std::vector<float>& picture) {
    double sum = 0.0;
    for (std::size_t i = 1; i < picture.size(); i += 4) sum += picture[i];
    return 4.0 * sum / static_cast<double>(picture.size());
  }
  static double difference(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0.0;
    for (std::size_t i = 1; i < a.size(); i += 4) sum += std::abs(a[i] - b[i]);
    return 4.0 * sum / static_cast<double>(a.size());
  }

  /// All of the sky in stratus without noise, that stands still.
  void show_even_layer(double density) {
    view_.weather = {.cover = 1.0, .type = 0.0, .precipitation = 0.0, .high = 0.0};
    view_.parameters.roughness = 0.0;
    view_.parameters.erosion = 0.0;
    view_.parameters.density = density;
    view_.parameters.evolution = 0.0;
  }

  std::unique_ptr<Cloudscape> clouds_;
  CelestialState sun_ = test::sun_at(200.0, 40.0);
  CloudView view_;
  float background_ = 0.0f;  ///< behind the clouds
  static constexpr int kMastWidth = 3;
  int mast_ = -1;  ///< left column of something near, as high as the picture; none below 0
};

TEST_F(CloudsTest, AClearSkyCostsNothing) {
  view_.weather.cover = 0.0;
  draw(90.0, 20.0);
  for (const PassReport& pass : graph_->report()) {
    // The block says that there are none.
    if (pass.name.rfind("clouds.", 0) != 0 || pass.name == "clouds.block") continue;
    EXPECT_EQ(pass.ran, 0) << pass.name;
  }
  for (const char* name :
       {"clouds.shadow", "clouds.march", "clouds.composite", "clouds.veils", "clouds.veils_draw"}) {
    EXPECT_EQ(row(name).skipped, 1) << name;
  }
  // Nor does a look at the water.
  view_.weather.cover = 0.5;
  draw(90.0, -60.0, 40.0);
  EXPECT_EQ(row("clouds.march").ran, 0);
}

TEST_F(CloudsTest, AStandingClockIsNotMarchedAgain) {
  constexpr int kRounds = 2 * 32;  // of the cells of quality low
  for (int frame = 0; frame < kRounds + 6; ++frame) draw(90.0, 20.0);
  EXPECT_LE(row("clouds.march").ran, kRounds + 1);
  EXPECT_GE(row("clouds.march").cached, 4);
  EXPECT_EQ(row("clouds.weather").ran, 1);
  EXPECT_EQ(row("clouds.noise").ran, 1);
  EXPECT_EQ(row("clouds.shadow").ran, 1);
  // And the picture stays.
  const std::vector<float> before = draw(90.0, 20.0);
  EXPECT_EQ(difference(before, draw(90.0, 20.0)), 0.0);
}

TEST_F(CloudsTest, MoreCoverHidesMoreSky) {
  double last = -1.0;
  for (const double cover : {0.05, 0.25, 0.5, 0.75, 1.0}) {
    clouds_ = std::make_unique<Cloudscape>(*shaders_, 0);
    view_.weather.cover = cover;
    background_ = 0.0f;
    const double light = mean(draw(20.0, 35.0, 100.0));
    background_ = 16.0f;
    const double hidden = 1.0 - (mean(draw(20.0, 35.0, 100.0)) - light) / 16.0;
    EXPECT_GT(hidden, last) << cover;
    last = hidden;
  }
}

TEST_F(CloudsTest, HasRecoveredFromACutWithinEightFrames) {
  for (int frame = 0; frame < 20; ++frame) draw(90.0, 20.0);
  std::vector<float> recovered;
  for (int frame = 0; frame < 8; ++frame) recovered = draw(190.0, 20.0);
  clouds_ = std::make_unique<Cloudscape>(*shaders_, 0);
  std::vector<float> whole;
  for (int frame = 0; frame < 64; ++frame) whole = draw(190.0, 20.0);
  EXPECT_GT(mean(whole), 0.01);
  EXPECT_LT(difference(recovered, whole), 0.08 * mean(whole));
}

TEST_F(CloudsTest, IsNearlyAsSharpWhileTheCameraTurnsAsWhenItStands) {
  // Twenty degrees a second at 60 frames, with pixels of .7 degrees: halves of a pixel, the worst
  // to draw anew in every frame. All of the picture, and what has come into it at the right.
  const struct {
    double height, pitch, all, right;
  } limits[] = {{3.0, 20.0, 0.22, 0.46}, {2500.0, -10.0, 0.26, 0.5}};
  for (const auto& limit : limits) {
    clouds_ = std::make_unique<Cloudscape>(*shaders_, 0);
    view_.eye.y = limit.height;
    std::vector<float> turning, standing;
    for (int frame = 0; frame <= 32; ++frame) turning = draw(190.0 + frame / 3.0, limit.pitch);
    clouds_ = std::make_unique<Cloudscape>(*shaders_, 0);
    for (int frame = 0; frame < 64; ++frame) standing = draw(190.0 + 32 / 3.0, limit.pitch);
    const auto right_of = [](const std::vector<float>& picture) {
      std::vector<float> part;
      for (std::size_t i = 0; i < picture.size(); i += 4) {
        if (static_cast<int>(i / 4) % kWidth >= kWidth - 16)
          part.insert(part.end(), picture.begin() + static_cast<std::ptrdiff_t>(i),
                      picture.begin() + static_cast<std::ptrdiff_t>(i) + 4);
      }
      return part;
    };
    const double all = difference(turning, standing) / mean(standing);
    const double right =
        difference(right_of(turning), right_of(standing)) / mean(right_of(standing));
    RecordProperty(fmt::format("from {}", limit.height), fmt::format("{:.4f} {:.4f}", all, right));
    EXPECT_GT(mean(right_of(standing)), 0.01);
    EXPECT_LT(all, limit.all) << limit.height;
    EXPECT_LT(right, limit.right) << limit.height;
  }
}

TEST_F(CloudsTest, AChangeIsSeenWhileTheClockStands) {
  for (int frame = 0; frame < 20; ++frame) draw(90.0, 20.0);
  const std::vector<float> before = draw(90.0, 20.0);
  for (const bool packed : {false, true}) {
    // Of the field, and of the noise that it reads.
    (packed ? view_.parameters.shape_weights[3] : view_.parameters.density) = 0.6;
    std::vector<float> after;
    for (int frame = 0; frame < 16; ++frame) after = draw(90.0, 20.0);
    clouds_ = std::make_unique<Cloudscape>(*shaders_, 0);
    std::vector<float> fresh;
    for (int frame = 0; frame < 64; ++frame) fresh = draw(90.0, 20.0);
    EXPECT_GT(difference(before, fresh), 0.02 * mean(fresh)) << packed;
    EXPECT_LT(difference(after, fresh), 0.1 * mean(fresh)) << packed;
  }
}

TEST_F(CloudsTest, AMovingMastLeavesNothingBehind) {
  // The same minutes with and without something near that goes through the picture: beside it not
  // a bit differs, in any frame. From within the clouds the picture asks for the depth itself.
  for (const double height : {3.0, 1000.0}) {
    std::vector<std::vector<float>> without;
    for (const bool mast : {false, true}) {
      clouds_ = std::make_unique<Cloudscape>(*shaders_, 0);
      view_.eye.y = height;
      view_.elapsed = 100.0;
      for (int frame = 0; frame < 12; ++frame) {
        view_.elapsed += 1.0 / 30.0;
        view_.drift = view_.elapsed * view_.wind_to * view_.wind_speed;
        mast_ = mast ? 10 + 5 * frame : -1;
        const std::vector<float> picture = draw(90.0 + 0.3 * frame, 20.0);
        if (!mast) {
          without.push_back(picture);
          continue;
        }
        for (std::size_t i = 0; i < picture.size(); ++i) {
          const int x = static_cast<int>(i / 4) % kWidth;
          const bool hidden = x >= mast_ && x < mast_ + kMastWidth;
          if (hidden && height < 500.0) {
            ASSERT_EQ(picture[i], i % 4 == 3 ? 1.0f : 0.0f) << "before the mast, frame " << frame;
          } else if (!hidden) {
            ASSERT_EQ(picture[i], without[static_cast<std::size_t>(frame)][i])
                << "frame " << frame << " column " << x << " eye at " << height;
          }
        }
      }
    }
  }
}

TEST_F(CloudsTest, DoNotFlicker) {
  // A camera that stands, a wind that blows: two seconds at 30 frames each, or as many as are asked
  // for. Over the sky's light.
  const char* asked = std::getenv("OFFING_FLICKER_SECONDS");
  const int frames = 30 * std::clamp(asked != nullptr ? std::atoi(asked) : 2, 1, 600);
  background_ = 1.0f;
  view_.weather.cover = 0.5;
  std::vector<float> last;
  double worst = 0.0, all = 0.0;
  int counted = 0;
  for (int frame = 0; frame < frames; ++frame) {
    view_.elapsed = 100.0 + frame / 30.0;
    view_.drift = view_.elapsed * view_.wind_to * view_.wind_speed;
    const std::vector<float> now = draw(90.0, 25.0);
    double sum = 0.0;
    for (std::size_t i = 1; i < now.size() && frame > 0; i += 4)
      sum += std::abs(shown(now[i]) - shown(last[i]));
    // The first round after a start still fills in.
    last = now;
    if (frame <= 8) continue;
    worst = std::max(worst, sum / (kWidth * kHeight));
    all += sum / (kWidth * kHeight);
    ++counted;
  }
  RecordProperty("worst", std::to_string(worst));
  RecordProperty("mean", std::to_string(all / counted));
  EXPECT_GT(all, 0.0);
  EXPECT_LT(worst, 1.0);
}

TEST_F(CloudsTest, ASmoothLayerHasNoBands) {
  // An even overcast without noise, toward the sun: light that changes evenly over the picture.
  // What bends in it by more than the display's steps would show as bands, which no dither hides.
  show_even_layer(0.1);
  background_ = 1.0f;
  std::vector<float> picture;
  for (int frame = 0; frame < 40; ++frame) picture = draw(200.0, 60.0, 40.0);
  double least = 255.0, most = 0.0, bend = 0.0;
  for (int y = 1; y + 1 < kHeight; ++y) {
    for (int x = 1; x + 1 < kWidth; ++x) {
      const auto at = [&](int i, int j) {
        return shown(picture[static_cast<std::size_t>(4 * ((y + j) * kWidth + x + i) + 1)]);
      };
      least = std::min(least, at(0, 0));
      most = std::max(most, at(0, 0));
      bend = std::max({bend, std::abs(at(-1, 0) - 2.0 * at(0, 0) + at(1, 0)),
                       std::abs(at(0, -1) - 2.0 * at(0, 0) + at(0, 1))});
    }
  }
  RecordProperty("bend", std::to_string(bend));
  EXPECT_GT(most - least, 5.0);
  EXPECT_LT(bend, 1.0);
}

TEST_F(CloudsTest, TheGlowRoundTheSunThroughAVeilHasNoSteps) {
  // A thin veil before the sun: what changes from ring to ring round it is how the droplets scatter
  // forward, which falls smoothly. The mean of a ring's logarithms leaves the veil's own unevenness
  // out.
  show_even_layer(0.05);
  std::vector<float> picture;
  for (int frame = 0; frame < 66; ++frame) picture = draw(200.0, 40.0, 30.0);
  constexpr int kRings = kHeight / 2, kFirst = 6;  // pixels; nearer, the peak bends too much
  std::array<double, kRings> sum{}, count{};
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double radius = std::hypot(x + 0.5 - kWidth / 2, y + 0.5 - kHeight / 2);
      const int ring = static_cast<int>(radius);
      if (ring >= kRings) continue;
      const float light = picture[static_cast<std::size_t>(4 * (y * kWidth + x) + 1)];
      // Within a ring by a power of the radius, so that its pixels may lie anywhere in it.
      sum[static_cast<std::size_t>(ring)] += std::log(light * std::pow(radius / (ring + 0.5), 2.0));
      ++count[static_cast<std::size_t>(ring)];
    }
  }
  double worst = 0.0;
  const auto at = [&](int ring) {
    return sum[static_cast<std::size_t>(ring)] / count[static_cast<std::size_t>(ring)];
  };
  for (int ring = kFirst; ring + 2 < kRings; ++ring) {
    EXPECT_LT(at(ring + 1), at(ring)) << ring;
    worst = std::max(worst,
                     std::abs(at(ring + 2) - 3.0 * at(ring + 1) + 3.0 * at(ring) - at(ring - 1)));
  }
  RecordProperty("worst", std::to_string(worst));
  EXPECT_LT(worst, 0.025);
}

TEST_F(CloudsTest, EverywhereAndInEveryLightIsFinite) {
  // Sun overhead, at the horizon, below it and exactly along the axes; eye below, inside and above.
  for (const double elevation : {90.0, 40.0, 0.0, -3.0}) {
    for (const double height : {3.0, 900.0, 4000.0}) {
      sun_.sun.azimuth_deg = 180.0;
      sun_.sun.elevation_deg = sun_.sun.elevation_airless_deg = elevation;
      view_.eye.y = height;
      view_.weather.cover = 0.6;
      clouds_ = std::make_unique<Cloudscape>(*shaders_, 0);
      for (const float value : draw(180.0, height > 1000.0 ? -20.0 : 10.0)) {
        ASSERT_TRUE(std::isfinite(value) && value >= 0.0f) << elevation << " " << height;
      }
    }
  }
}

TEST_F(CloudsTest, ASunExactlyAlongAnAxisIsNoSpecialCase) {
  // Straight up, at the horizon, along x and z, and from the first frame on: a thousandth of a
  // degree beside it is as bright everywhere, also straight into the light, where the phase
  // function's peak makes most of what differs.
  constexpr double kBeside = 0.001;  // degrees
  for (const auto& [azimuth, elevation] : {std::pair(0.0, 90.0),
                                           {180.0, 89.99},
                                           {0.0, 0.0},
                                           {90.0, 0.0},
                                           {180.0, 20.0},
                                           {270.0, 45.0}}) {
    std::vector<float> pictures[2];
    for (const int beside : {0, 1}) {
      sun_.sun.azimuth_deg = azimuth + kBeside * beside;
      sun_.sun.elevation_deg = sun_.sun.elevation_airless_deg = elevation - kBeside * beside;
      clouds_ = std::make_unique<Cloudscape>(*shaders_, 0);
      pictures[beside] = draw(azimuth, std::min(elevation, 60.0) + 5.0);
    }
    EXPECT_GT(mean(pictures[0]), 0.0) << azimuth << " " << elevation;
    EXPECT_LT(difference(pictures[0], pictures[1]), 0.004 * mean(pictures[0]))
        << azimuth << " " << elevation;
    for (const float value : pictures[0]) ASSERT_TRUE(std::isfinite(value) && value >= 0.0f);
  }
}

TEST_F(CloudsTest, TheShadowMapHoldsTheDepthOfTheField) {
  // Without noise the field is the weather alone, and can be integrated in double from the map.
  view_.weather = {.cover = 0.6, .type = 0.5, .precipitation = 0.0, .high = 0.0};
  view_.parameters.roughness = 0.0;
  view_.parameters.erosion = 0.0;
  view_.parameters.shear = 0.0;
  const SkyLight& light = model_.update(sun_, 0.1, view_.eye.y);
  shared::CloudData data = cloud_data(view_, light);
  std::vector<float> weather, shadow;
  graph_->begin_frame();
  const CloudscapeIds ids = clouds_->add_field(*graph_, view_, light);
  graph_->add(
      "read",
      [&](PassBuilder& pass) { pass.read(ids.field.weather).read(ids.shadow.map).side_effect(); },
      [&](PassContext& context) {
        weather = context.texture(ids.field.weather).read_floats(4);
        shadow = context.texture(ids.shadow.map).read_floats(4);
      });
  graph_->execute();

  constexpr int kWeather = WeatherMap::kTexels, kShadow = CloudShadow::kTexels;
  const auto weather_at = [&](glm::dvec2 plan, int channel) {
    const glm::dvec2 at = (glm::dvec2(data.weather) + plan * static_cast<double>(data.weather.z)) *
                              static_cast<double>(kWeather) -
                          0.5;
    const glm::dvec2 cell = glm::floor(at), f = at - cell;
    const auto texel = [&](int i, int j) {
      const int x = ((static_cast<int>(cell.x) + i) % kWeather + kWeather) % kWeather;
      const int y = ((static_cast<int>(cell.y) + j) % kWeather + kWeather) % kWeather;
      return static_cast<double>(
          weather[static_cast<std::size_t>(4 * (y * kWeather + x) + channel)]);
    };
    return glm::mix(glm::mix(texel(0, 0), texel(1, 0), f.x),
                    glm::mix(texel(0, 1), texel(1, 1), f.x), f.y);
  };
  // The map's middle lies at a step of its own grid.
  const glm::dvec3 toward = glm::normalize(glm::dvec3(data.light_direction));
  const glm::dvec2 eye = glm::dvec2(0.0) - cloud_carried(view_, data.layer.w);
  const double grid = CloudShadow::kSide / 8.0;
  const glm::dvec2 middle = grid * glm::round(eye / grid) - eye;
  double worst = 0.0, sum = 0.0, exact_sum = 0.0;
  int compared = 0;
  for (int y = 20; y < kShadow; y += 11) {
    for (int x = 20; x < kShadow; x += 11) {
      const glm::dvec2 plan =
          middle +
          ((glm::dvec2(x, y) + 0.5) / static_cast<double>(kShadow) - 0.5) * CloudShadow::kSide;
      double depth = 0.0;
      constexpr int kSteps = 3000;
      const double up = (data.layer.y - data.layer.w) / toward.y;
      const double down = (data.layer.x - data.layer.w) / toward.y;
      for (int i = 0; i < kSteps; ++i) {
        const double t = down + (up - down) * (i + 0.5) / kSteps;
        const glm::dvec2 p = plan + t * glm::dvec2(toward.x, toward.z);
        const double altitude = data.layer.w + t * toward.y;
        const glsl::CloudKind kind = glsl::cloud_kind(weather_at(p, 1));
        const double base = glm::mix(static_cast<double>(data.layer.x),
                                     2.0 * data.layer.w - data.layer.x, weather_at(p, 2));
        const double h = (altitude - base) / kind.thickness;
        const double strength = glsl::cloud_strength(kind, weather_at(p, 0) - data.weather.w);
        const double inside =
            kind.sharpness * (strength - glsl::cloud_outline(kind, h)) + kind.given;
        depth += data.layer.z * kind.extinction * glsl::cloud_filling(h) *
                 std::clamp(inside / glsl::kCloudEdgeWidth, 0.0, 1.0) * (up - down) / kSteps;
      }
      const double seen = shadow[static_cast<std::size_t>(4 * (y * kShadow + x))];
      worst = std::max(worst, std::abs(std::exp(-0.15 * seen) - std::exp(-0.15 * depth)));
      sum += seen;
      exact_sum += depth;
      ++compared;
    }
  }
  EXPECT_GT(exact_sum / compared, 0.5);
  EXPECT_NEAR(sum / exact_sum, 1.0, 0.03);
  EXPECT_LT(worst, 0.1);
}

}  // namespace
}  // namespace offing
