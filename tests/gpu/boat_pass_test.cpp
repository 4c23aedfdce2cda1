#include "game/frame/boat_shadow.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <optional>

#include "engine/core/paths.h"
#include "engine/graph/gl_device.h"
#include "game/world/camera.h"
#include "support/even_light.h"
#include "support/gl_test.h"

namespace offing {
namespace {

constexpr int kWidth = 160, kHeight = 120;
constexpr float kFieldOfView = 0.8f;
constexpr float kBackground = 0.25f;
constexpr int kShadowQuality = 1;
constexpr float kMast = -0.6f;  // m abaft amidships: the axis of the mast, 15 cm thick

/// A picture of the boat, row 0 at the bottom.
struct Picture {
  std::vector<float> rgba;
  std::vector<float> depth;
  const float* at(int x, int y) const {
    return &rgba[4 * static_cast<std::size_t>(y * kWidth + x)];
  }
  float luminance(int x, int y) const {
    const float* p = at(x, y);
    return 0.2126f * p[0] + 0.7152f * p[1] + 0.0722f * p[2];
  }
  float depth_at(int x, int y) const { return depth[static_cast<std::size_t>(y * kWidth + x)]; }
};

class BoatPicture : public test::GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped()) return;
    shaders_.emplace(data_root() / "shaders");
    const Model model = load_model(data_root() / "assets/models/r8/r8.glb", kBoatNodeNames, 80'000);
    pass_.emplace(*shaders_, model, load_boat_textures(data_root() / "assets/textures"));
    device_.emplace();
    light_.emplace();
    shadow_.emplace(kShadowQuality);
    graph_.emplace(*device_);
    hdr_ = gl::Texture("hdr", {.format = GL_RGBA16F, .width = kWidth, .height = kHeight});
    depth_ =
        gl::Texture("depth", {.format = GL_DEPTH_COMPONENT32F, .width = kWidth, .height = kHeight});
    block_ = gl::Buffer("frame", sizeof(shared::FrameData));
    frame_.viewport = {kWidth, kHeight, 1.0f / kWidth, 1.0f / kHeight};
    frame_.sun_direction = {0.0f, 1.0f, 0.0f, 1.0f};
    frame_.sun_illuminance = {90e3f, 90e3f, 90e3f, 1.0f};
    frame_.moon_direction = {0.0f, -1.0f, 0.0f, 1.0f};
    frame_.sky_illuminance = {10e3f, 10e3f, 10e3f, 0.0f};
    frame_.time = {3.0f, 1.0f / 60.0f, 1.0f / 20e3f, 0.0f};
    look({25.0f, 6.0f, 0.0f}, {0.0f, 4.5f, 0.0f}, {0.0f, 1.0f, 0.0f});
  }

  /// With the boat's origin at the world's.
  void look(glm::vec3 eye, glm::vec3 target, glm::vec3 up, float fov = kFieldOfView) {
    frame_.clip_from_relative =
        reversed_projection(fov, static_cast<double>(kWidth) / kHeight, 0.1) *
        glm::lookAt(glm::vec3(0.0f), target - eye, up);
    frame_.relative_from_clip = glm::inverse(frame_.clip_from_relative);
    frame_.camera = {0.0f, eye.y, 0.0f, fov / kHeight};
    eye_ = eye;
  }

  /// From high above, 7 cm a pixel in the middle of the sails, the bow up.
  void look_down() { look({0.0f, 55.0f, -0.2f}, {0.0f, 0.0f, -0.2f}, {0.0f, 0.0f, -1.0f}, 0.165f); }

  void run(BoatView view, bool with_mask) {
    view.position = -eye_;
    block_.write(frame_);
    graph_->begin_frame();
    const TextureId hdr = graph_->import(hdr_), depth = graph_->import(depth_);
    graph_->add(
        "clear",
        [&](PassBuilder& pass) {
          pass.write(hdr, Access::kAttachment)
              .write(depth, Access::kAttachment)
              .render_to({hdr}, depth);
        },
        [&](PassContext&) {
          const float colour[4] = {kBackground, kBackground, kBackground, 1.0f}, far = 0.0f;
          block_.bind_uniform(0);
          glDepthMask(GL_TRUE);
          glClearBufferfv(GL_COLOR, 0, colour);
          glClearBufferfv(GL_DEPTH, 0, &far);
        });
    shadow_->add(*graph_, *pass_, view, frame_);
    const LightAccess even = light_->access();
    const LightAccess light{[&](PassBuilder& pass) { shadow_->read_by(pass); },
                            [&](const PassContext& context) {
                              even.bind(context);
                              shadow_->bind();
                            }};
    pass_->add(*graph_, view, frame_, light, hdr, depth);
    TextureId mask;
    if (with_mask) mask = pass_->add_mask(*graph_, view, frame_);
    graph_->add(
        "look",
        [&](PassBuilder& pass) {
          pass.read(hdr).read(depth).side_effect();
          if (with_mask) pass.read(mask);
        },
        [&](PassContext& context) {
          picture_ = {hdr_.read_floats(4), {}};
          picture_.depth.resize(static_cast<std::size_t>(kWidth) * kHeight);
          glGetTextureImage(depth_.id(), 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                            static_cast<GLsizei>(picture_.depth.size() * sizeof(float)),
                            picture_.depth.data());
          if (with_mask) mask_ = context.texture(mask).read_floats(2);
        });
    graph_->execute();
  }
  Picture draw(const BoatView& view) {
    run(view, false);
    return picture_;
  }

  /// Seen from the masthead's height and more, bow up: how many points of the rig that are higher
  /// than `above` lie to starboard (+) and to port (-) of the centreline, beyond `beside` metres.
  std::pair<int, int> rig_points(const Picture& picture, float above, float beside) const {
    int port = 0, starboard = 0;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const float z = picture.depth_at(x, y);
        if (z <= 0.0f) continue;
        const glm::vec4 clip(2.0f * (static_cast<float>(x) + 0.5f) / kWidth - 1.0f,
                             2.0f * (static_cast<float>(y) + 0.5f) / kHeight - 1.0f, z, 1.0f);
        const glm::vec4 relative = frame_.relative_from_clip * clip;
        const glm::vec3 place = glm::vec3(relative) / relative.w + eye_;
        if (place.y < above) continue;
        if (place.x > beside) ++starboard;
        if (place.x < -beside) ++port;
      }
    }
    return {port, starboard};
  }

  std::optional<ShaderLibrary> shaders_;
  std::optional<BoatPass> pass_;
  std::optional<GlDevice> device_;
  std::optional<FrameGraph> graph_;
  std::optional<test::EvenLight> light_;
  std::optional<BoatShadow> shadow_;
  gl::Texture hdr_, depth_;
  gl::Buffer block_;
  shared::FrameData frame_{};
  glm::vec3 eye_{0.0f};
  Picture picture_;
  std::vector<float> mask_;
};

TEST_F(BoatPicture, IsThereFiniteAndLeavesTheRestAlone) {
  BoatView view;
  view.main = {0.2f, 0.8f, 0.3f};
  view.jib = {0.2f, 0.8f, 0.3f};
  view.apparent_wind = {4.0f, 0.0f, 5.0f};
  const Picture picture = draw(view);
  int drawn = 0, kept = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const float* p = picture.at(x, y);
      for (int channel = 0; channel < 3; ++channel) {
        ASSERT_TRUE(std::isfinite(p[channel]) && p[channel] >= 0.0f) << x << ", " << y;
      }
      if (picture.depth_at(x, y) > 0.0f) {
        ++drawn;
      } else {
        EXPECT_EQ(p[0], kBackground);
        ++kept;
      }
    }
  }
  // Her 34 m² of sail alone, seen square on from 25 m, cover this many pixels; hull and mast add to
  // it.
  const double pixels_per_metre = kHeight / (2.0 * 25.0 * std::tan(kFieldOfView / 2.0));
  EXPECT_GT(drawn, 0.7 * 34.0 * pixels_per_metre * pixels_per_metre);
  EXPECT_GT(kept, kWidth * kHeight / 2);
}

TEST_F(BoatPicture, SailsBellyToLeewardAndMirrorWithTheWind) {
  look_down();
  BoatView starboard;  // pressed to starboard, the chord on the centreline
  starboard.main.fill = starboard.jib.fill = 1.0f;
  BoatView port;
  port.main.fill = port.jib.fill = -1.0f;
  // What is higher than 2.2 m and farther than 0.1 m from the centreline: cloth, and the spreaders
  // and shrouds that are there without it too.
  const auto [port_rig, starboard_rig] = rig_points(draw(BoatView{}), 2.2f, 0.1f);
  const auto [port_a, starboard_a] = rig_points(draw(starboard), 2.2f, 0.1f);
  const auto [port_b, starboard_b] = rig_points(draw(port), 2.2f, 0.1f);
  // Two bellies a tenth of their chord deep cover at least half a square metre there; a pixel is
  // 0.005 m².
  EXPECT_GT(starboard_a - starboard_rig, 100);
  EXPECT_LE(port_a, port_rig);
  EXPECT_NEAR(starboard_a - starboard_rig, port_b - port_rig, 0.1 * (starboard_a - starboard_rig));
  EXPECT_LE(starboard_b, starboard_rig);
}

TEST_F(BoatPicture, BoomSwingsTheMainsailToItsSide) {
  look_down();
  BoatView view;
  const auto [port_rig, starboard_rig] = rig_points(draw(view), 2.2f, 0.9f);
  view.main = {1.2f, 0.8f, 0.0f};
  const auto [port, starboard] = rig_points(draw(view), 2.2f, 0.9f);
  EXPECT_GT(starboard, starboard_rig + 40);
  EXPECT_LE(port, port_rig);
}

TEST_F(BoatPicture, SailsGlowWhenTheSunIsBehindThem) {
  BoatView view;
  frame_.sun_direction = {0.8f, 0.6f, 0.0f, 1.0f};
  // A point of the mainsail 0.7 m abaft midships and 5 m up, from either side.
  const int y = kHeight / 2 + 4, left = kWidth / 2 - 4, right = kWidth / 2 + 4;
  const float lit = draw(view).luminance(left, y);
  look({-25.0f, 6.0f, 0.0f}, {0.0f, 4.5f, 0.0f}, {0.0f, 1.0f, 0.0f});
  const float behind = draw(view).luminance(right, y);
  ASSERT_GT(picture_.depth_at(right, y), 0.0f);
  frame_.sun_illuminance = glm::vec4(0.0f);
  const float sunless = draw(view).luminance(right, y);
  EXPECT_GT(lit, 2.0f * behind);
  EXPECT_GT(behind, 1.5f * sunless);
}

// In the sun from starboard, 45 degrees high: a point of the sea as far to port of the centreline
// as a part of the mast is high lies in its shadow; a metre before and abaft it there is light.
TEST_F(BoatPicture, TheMastThrowsItsShadowWhereGeometryPutsIt) {
  const float half = std::sqrt(0.5f);
  frame_.sun_direction = {half, half, 0.0f, 1.0f};
  BoatView view;
  view.hoisted = false;
  draw(view);
  const gl::Texture& map = shadow_->map();
  std::vector<float> depth(static_cast<std::size_t>(map.width()) * map.height());
  glGetTextureImage(map.id(), 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                    static_cast<GLsizei>(depth.size() * sizeof(float)), depth.data());
  view.position = -eye_;
  const shared::BoatShadowData data = boat_shadow_data(view, frame_, map.height(), 1);
  const auto lit = [&](const glm::vec3& place) {
    const glm::vec4 at = data.map_from_relative * glm::vec4(place - eye_, 1.0f);
    if (std::max(std::abs(at.x - 0.5f), std::abs(at.y - 0.5f)) >= 0.5f) return true;
    const auto column = static_cast<std::size_t>(at.x * static_cast<float>(map.height()));
    const auto row = static_cast<std::size_t>(at.y * static_cast<float>(map.height()));
    return std::min(at.z, 1.0f) <= depth[row * static_cast<std::size_t>(map.width()) + column];
  };
  for (const float height : {5.0f, 7.5f, 10.0f}) {
    int dark = 0;
    for (const float off : {-0.05f, 0.0f, 0.05f}) dark += !lit({-height, 0.0f, kMast + off});
    EXPECT_GE(dark, 2) << height;
    EXPECT_TRUE(lit({-height, 0.0f, kMast + 1.0f})) << height;
    EXPECT_TRUE(lit({-height, 0.0f, kMast - 1.0f})) << height;
    EXPECT_TRUE(lit({height, 0.0f, kMast})) << height;  // toward the sun
  }
}

// Of the deck to leeward of the mainsail, in the sun from starboard: the sail takes away all of the
// direct light but the share that cloth lets through.
TEST_F(BoatPicture, TheSailsShadowIsAsDarkAsItsCloth) {
  look_down();
  const float up = std::sin(1.05f);
  frame_.sun_direction = {std::sqrt(1.0f - up * up), up, 0.0f, 1.0f};
  const auto deck = [&](bool hoisted) {
    BoatView view;
    view.hoisted = hoisted;
    const Picture picture = draw(view);
    float sum = 0.0f;
    int count = 0;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const glm::vec4 clip(2.0f * (static_cast<float>(x) + 0.5f) / kWidth - 1.0f,
                             2.0f * (static_cast<float>(y) + 0.5f) / kHeight - 1.0f,
                             picture.depth_at(x, y), 1.0f);
        const glm::vec4 relative = frame_.relative_from_clip * clip;
        const glm::vec3 place = glm::vec3(relative) / relative.w + eye_;
        if (place.y > 1.3f || place.x < -0.95f || place.x > -0.75f) continue;
        if (place.z < 0.2f || place.z > 1.2f) continue;
        sum += picture.luminance(x, y);
        ++count;
      }
    }
    EXPECT_GT(count, 10);
    return sum / static_cast<float>(count);
  };
  const float shaded = deck(true), sunny = deck(false);
  frame_.sun_illuminance = glm::vec4(0.0f);
  const float dark = deck(false);
  EXPECT_GT(sunny, 2.0f * dark);
  EXPECT_NEAR((shaded - dark) / (sunny - dark), mainsail_style().through, 0.03f);
}

TEST_F(BoatPicture, WithoutALightThereIsNoShadowToDraw) {
  frame_.sun_illuminance = frame_.moon_illuminance = glm::vec4(0.0f);
  graph_->reset_report();
  draw(BoatView{});
  for (const PassReport& pass : graph_->report()) {
    EXPECT_EQ(pass.skipped, pass.name == "boat.shadow") << pass.name;
  }
}

// From starboard one sees the green light and not the red one, from astern the white one alone,
// from ahead under power the masthead light as well.
TEST_F(BoatPicture, EachLampIsSeenOverItsArc) {
  frame_.sun_illuminance = frame_.sky_illuminance = glm::vec4(0.0f);
  BoatView view;
  view.navigation_lights = 1.0f;
  view.hoisted = false;
  const glm::vec3 bow(0.0f, 1.4f, -3.7f), stern(-0.4f, 1.5f, 3.7f), masthead(0.0f, 11.9f, -0.6f);
  const auto shining = [&](glm::vec3 from, glm::vec3 at) {
    look(from, at, {0.0f, 1.0f, 0.0f}, 0.12f);
    const Picture picture = draw(view);
    glm::ivec3 pixels(0);  // red, green, white
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const float* p = picture.at(x, y);
        const bool grey = std::abs(p[2] - p[0]) < 0.1f * p[0];  // a wire over the background
        if (picture.depth_at(x, y) <= 0.0f || std::max(p[0], p[1]) < 1e-3f || grey) continue;
        ++pixels[p[2] > 0.5f * p[0] && p[0] > 0.5f * p[1] ? 2 : p[0] > p[1] ? 0 : 1];
      }
    }
    return pixels;
  };
  const glm::ivec3 starboard = shining({9.0f, 3.0f, -9.0f}, bow),
                   port = shining({-9.0f, 3.0f, -9.0f}, bow);
  EXPECT_EQ(starboard.x, 0);
  EXPECT_GT(starboard.y, 0);
  EXPECT_EQ(starboard.z, 0);
  EXPECT_GT(port.x, 0);
  EXPECT_EQ(port.y, 0);
  const glm::ivec3 astern = shining({0.0f, 3.0f, 12.0f}, stern);
  EXPECT_EQ(astern.x + astern.y, 0);
  EXPECT_GT(astern.z, 0);
  EXPECT_EQ(shining({9.0f, 8.0f, -9.0f}, masthead).z, 0);
  view.under_power = true;
  EXPECT_GT(shining({9.0f, 8.0f, -9.0f}, masthead).z, 0);
}

// From far off a lamp is smaller than a pixel: wherever it lies among them it gives the light that
// it gives where it is many pixels large.
TEST_F(BoatPicture, ALampIsNotLostBetweenPixels) {
  frame_.sun_illuminance = frame_.sky_illuminance = glm::vec4(0.0f);
  const glm::vec3 stern(-0.4f, 1.5f, 3.7f), eye(0.0f, 4.0f, 30.0f), up(0.0f, 1.0f, 0.0f);
  // All of its light, in units of the exposed luminance times rad^2.
  const auto light = [&](glm::vec3 target, float fov) {
    look(eye, target, up, fov);
    const auto sum = [&](float lights) {
      BoatView view;
      view.navigation_lights = lights;
      view.hoisted = false;
      const Picture picture = draw(view);
      double all = 0.0;
      for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) all += picture.luminance(x, y);
      }
      return all;
    };
    const double pixel = fov / kHeight;
    return (sum(1.0f) - sum(0.0f)) * pixel * pixel;
  };
  const double large = light(stern, 0.02f);
  ASSERT_GT(large, 0.0);
  double mean = 0.0;
  constexpr int kPlaces = 16;
  const float pixel = kFieldOfView / kHeight * glm::distance(eye, stern);  // m
  for (int i = 0; i < kPlaces; ++i) {
    const auto turn = static_cast<float>(i);
    const glm::vec3 aside(pixel * turn / kPlaces, pixel * std::fmod(turn * 0.618f, 1.0f), 0.0f);
    const double seen = light(stern + aside, kFieldOfView) / large;
    EXPECT_GT(seen, 0.4) << i;
    EXPECT_LT(seen, 2.0) << i;
    mean += seen / kPlaces;
  }
  EXPECT_NEAR(mean, 1.0, 0.2);
}

TEST_F(BoatPicture, IsSkippedOutOfView) {
  look({0.0f, 5.0f, 40.0f}, {0.0f, 5.0f, 80.0f}, {0.0f, 1.0f, 0.0f});
  graph_->reset_report();
  draw(BoatView{});
  for (const PassReport& pass : graph_->report()) {
    if (pass.name == "boat") {
      EXPECT_EQ(pass.skipped, 1);
      EXPECT_EQ(pass.ran, 0);
    }
  }
}

TEST_F(BoatPicture, MaskBracketsTheHull) {
  look({20.0f, 0.3f, 0.0f}, {0.0f, 0.3f, 0.0f}, {0.0f, 1.0f, 0.0f});
  run(BoatView{}, true);
  const std::size_t middle = 2 * static_cast<std::size_t>(kHeight / 2 * kWidth + kWidth / 2);
  // Square on at 0.3 m, where she is between her waterline's 2.05 m and her deck's 2.5 m broad.
  const float near = 1.0f / mask_[middle], far = mask_[middle + 1];
  EXPECT_GT(near, 20.0f - 1.27f);
  EXPECT_LT(near, 20.0f - 1.00f);
  EXPECT_GT(far, 20.0f + 1.00f);
  EXPECT_LT(far, 20.0f + 1.27f);
  const std::size_t sky = 2 * static_cast<std::size_t>((kHeight - 2) * kWidth + kWidth / 2);
  EXPECT_EQ(mask_[sky], 0.0f);
  EXPECT_EQ(mask_[sky + 1], 0.0f);
}

TEST(Flag, StreamsDownTheWindAndDroopsInACalm) {
  const glm::vec3 down(0.0f, -1.0f, 0.0f);
  const FlagPose breeze = flag_pose({10.0f, 0.0f, 0.0f}, down);  // blows to starboard
  EXPECT_NEAR(breeze.yaw, 1.5708f, 1e-4f);
  EXPECT_GT(breeze.stream.z, 0.99f);
  const FlagPose calm = flag_pose(glm::vec3(0.0f), down);
  EXPECT_LT(calm.stream.y, -0.9f);
  // Heeled to starboard in a calm it hangs to the earth, not to the keel: 30 degrees off the hoist.
  const FlagPose heeled = flag_pose(glm::vec3(0.0f), {0.5f, -0.866f, 0.0f});
  EXPECT_GT(heeled.stream.x, 0.4f);
}

TEST(Cloth, ClockTicksAndSidesMirror) {
  ClothStyle style = mainsail_style();
  style.time_step = 0.5f;
  const SailView starboard{0.1f, 0.7f, 0.2f}, port{-0.1f, -0.7f, 0.2f};
  const auto a = sail_cloth(style, starboard, 3.1, 4);
  const auto b = sail_cloth(style, port, 3.4, 4);
  EXPECT_EQ(a.clock.x, 3.0f);
  EXPECT_EQ(b.clock.x, 3.0f);
  EXPECT_EQ(a.belly.x, -b.belly.x);
  EXPECT_EQ(a.belly.y, -b.belly.y);
  EXPECT_GT(a.belly.x, 0.0f);
}

}  // namespace
}  // namespace offing
