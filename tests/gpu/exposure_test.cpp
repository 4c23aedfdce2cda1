#include "engine/post/exposure.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "engine/post/bloom.h"
#include "engine/post/tonemap.h"
#include "support/graph_test.h"

namespace offing {
namespace {

constexpr int kWidth = 96, kHeight = 64;

class ExposureTest : public test::GraphTest {
 protected:
  void SetUp() override {
    GraphTest::SetUp();
    if (IsSkipped()) return;
    exposure_ = std::make_unique<Exposure>(*shaders_);
    bloom_ = std::make_unique<Bloom>(*shaders_);
    hdr_ = gl::Texture("hdr", {.format = GL_RGBA32F, .width = kWidth, .height = kHeight});
  }

  /// A frame of an even picture of this luminance (cd/m^2); log2 of the exposure that follows.
  double frame(double luminance, const PictureLight& light, const ExposureSettings& settings) {
    const auto value = static_cast<float>(luminance * light.exposure);
    hdr_.upload(GL_RGBA, GL_FLOAT, std::vector<float>(kWidth * kHeight * 4, value).data());
    graph_->begin_frame();
    const BufferId state = exposure_->add(*graph_, graph_->import(hdr_), light, settings);
    graph_->add(
        "use", [&](PassBuilder& pass) { pass.read(state).side_effect(); }, [](PassContext&) {});
    graph_->execute();
    return std::log2(exposure_->read().exposure);
  }

  /// The glow of a picture that is black but for what `draw` makes.
  std::vector<float> glow(const std::vector<float>& pixels, int* width) {
    hdr_.upload(GL_RGBA, GL_FLOAT, pixels.data());
    graph_->begin_frame();
    const TextureId id = bloom_->add(*graph_, graph_->import(hdr_));
    std::vector<float> result;
    graph_->add(
        "read", [&](PassBuilder& pass) { pass.read(id).side_effect(); },
        [&](PassContext& context) {
          *width = context.texture(id).width();
          result = context.texture(id).read_floats(4);
        });
    graph_->execute();
    return result;
  }

  std::unique_ptr<Exposure> exposure_;
  std::unique_ptr<Bloom> bloom_;
  gl::Texture hdr_;
};

TEST_F(ExposureTest, MetersWhatIsThere) {
  for (const double luminance : {2e-4, 0.3, 40.0, 9000.0}) {
    frame(luminance, {.exposure = 0.2 / luminance, .luminance = luminance, .dt = 0.0}, {});
    // A bin is 0.63 of a stop wide.
    EXPECT_NEAR(std::log2(exposure_->read().luminance / luminance), 0.0, 0.35);
  }
}

TEST_F(ExposureTest, IsAdaptedAtOnceAndThenOverSeconds) {
  const ExposureSettings settings;
  const PictureLight day{.exposure = 1e-4, .luminance = 3000.0, .dt = 0.1};
  const double first = frame(1000.0, day, settings);
  EXPECT_NEAR(frame(1000.0, day, settings), first, 1e-3);
  // Into a cave: a picture so dark that only the limit holds.
  const double goal = std::log2(day.exposure) + settings.brightest;
  double last = frame(1.0, day, settings);
  EXPECT_LT(last, goal - 0.5 * (goal - first));
  double time = 0.1;
  for (; time < settings.seconds - 0.05; time += 0.1) {
    const double now = frame(1.0, day, settings);
    EXPECT_GE(now, last);
    last = now;
  }
  EXPECT_NEAR((goal - last) / (goal - first), std::exp(-time / settings.seconds), 0.03);
  // And out again, faster.
  EXPECT_GT(last - frame(1000.0, day, settings), 2.0 * (goal - last) * 0.08);
}

TEST_F(ExposureTest, KeepsToItsLimitsAndPreference) {
  ExposureSettings settings;
  const PictureLight light{.exposure = 0.01, .luminance = 30.0, .dt = 0.0};
  settings.seconds = 0.0;
  settings.darkest = -0.5;
  settings.brightest = 0.75;
  EXPECT_NEAR(frame(1e-4, light, settings), std::log2(0.01) + 0.75, 1e-3);
  EXPECT_NEAR(frame(1e6, light, settings), std::log2(0.01) - 0.5, 1e-3);
  settings.ev = 1.5;
  EXPECT_NEAR(frame(1e6, light, settings), std::log2(0.01) + 1.0, 1e-3);
}

TEST_F(ExposureTest, ByHandItIsWhatThePhotographerSays) {
  ExposureSettings settings;
  settings.mode = static_cast<int>(ExposureMode::kManual);
  settings.ev100 = 15.0;
  // ISO 2720: at EV 15 the sensor is full at 1.2 × 2^15 cd/m^2.
  EXPECT_NEAR(frame(77.0, {.exposure = 0.3, .luminance = 1.0, .dt = 0.1}, settings),
              -std::log2(39321.6), 1e-3);
}

TEST_F(ExposureTest, GlowMakesNoLight) {
  int width = 0;
  // An even picture stays what it is.
  for (const float value : glow(std::vector<float>(kWidth * kHeight * 4, 0.7f), &width)) {
    if (value != 1.0f) {
      EXPECT_NEAR(value, 0.7f, 1e-3f);
    }
  }
  // A lamp in the middle: all its light is somewhere, most of it near, none of it beside the axis.
  std::vector<float> lamp(kWidth * kHeight * 4, 0.0f);
  const int at = 4 * (kHeight / 2 * kWidth + kWidth / 2);
  for (int c = 0; c < 3; ++c) lamp[static_cast<std::size_t>(at + c)] = 4000.0f;
  const auto spread = glow(lamp, &width);
  double sum = 0.0;
  for (std::size_t i = 0; i < spread.size(); i += 4) sum += spread[i];
  // What reaches the frame's edge is held there, so it is not exactly all of it.
  EXPECT_NEAR(16.0 * sum / 4000.0, 1.0, 0.1);
  const auto pixel = [&](int x, int y) {
    return spread[static_cast<std::size_t>(4 * (y * width + x))];
  };
  EXPECT_GT(pixel(12, 8), 4.0f * pixel(16, 8));
  EXPECT_GT(pixel(16, 8), pixel(20, 8));
  EXPECT_GT(pixel(20, 8), 0.0f);
}

// The sun is thousands of times as bright as white, so its glow shows down to the last of its
// kernel's tails.
TEST_F(ExposureTest, TheGlowOfADiscIsRound) {
  Tonemap tonemap(*shaders_);
  const gl::Texture out("out", {.format = GL_RGBA8, .width = kWidth, .height = kHeight});
  double squares = 0.0;
  constexpr int kShifts = 16;
  for (int i = 0; i < kShifts; ++i) {
    const float shift = 4.0f * static_cast<float>(i) / kShifts;  // over one texel of the glow
    const glm::vec2 middle(kWidth / 2 + shift, kHeight / 2 + 0.6f * shift);
    std::vector<float> disc(kWidth * kHeight * 4, 0.0f);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const float away = glm::distance(glm::vec2(x, y) + 0.5f, middle);
        const float share = std::clamp(2.0f - away, 0.0f, 1.0f);
        for (int c = 0; c < 3; ++c) {
          disc[static_cast<std::size_t>(4 * (y * kWidth + x) + c)] = 1e4f * share;
        }
      }
    }
    hdr_.upload(GL_RGBA, GL_FLOAT, disc.data());
    graph_->begin_frame();
    const TextureId hdr = graph_->import(hdr_), shown = graph_->import(out);
    const TextureId glow = bloom_->add(*graph_, hdr);
    tonemap.add(*graph_, hdr, shown, {.exposure = 1e-5, .glow_share = 0.025}, {}, glow);
    graph_->add(
        "show", [&](PassBuilder& pass) { pass.read(shown).side_effect(); }, [](PassContext&) {});
    graph_->execute();
    const std::vector<float> picture = out.read_floats(4);
    // The part that is nearly white: r^4 cos 4a over r^4 is 0 for a disc, -.43 for a square.
    double four = 0.0, all = 0.0;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        if (picture[static_cast<std::size_t>(4 * (y * kWidth + x))] < 0.97f) continue;
        const glm::dvec2 d = glm::dvec2(x, y) + 0.5 - glm::dvec2(middle);
        four += std::pow(d.x, 4) - 6.0 * d.x * d.x * d.y * d.y + std::pow(d.y, 4);
        all += std::pow(glm::dot(d, d), 2);
      }
    }
    ASSERT_GT(all, 0.0);
    squares += std::pow(four / all, 2) / kShifts;
  }
  EXPECT_LT(std::sqrt(squares), 0.1);
}

TEST_F(ExposureTest, OneBadPixelDoesNotSpread) {
  std::vector<float> pixels(kWidth * kHeight * 4, 0.5f);
  pixels[4 * 777] = std::numeric_limits<float>::quiet_NaN();
  pixels[4 * 2000 + 1] = std::numeric_limits<float>::infinity();
  int width = 0;
  for (const float value : glow(pixels, &width)) ASSERT_TRUE(std::isfinite(value));
}

}  // namespace
}  // namespace offing
