#include "engine/post/antialias.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <functional>
#include <vector>

#include "support/graph_test.h"

namespace offing {
namespace {

constexpr int kWidth = 96, kHeight = 64;
constexpr double kLight = 0.6, kDark = 0.05;  // linear

double srgb(double x) {
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
}
double linear(double x) { return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); }

/// A bright thing on dark ground, each pixel the one or the other.
class AntialiasTest : public test::GraphTest {
 protected:
  using Inside = std::function<bool(double x, double y)>;

  void SetUp() override {
    GraphTest::SetUp();
    antialias_ = std::make_unique<Antialias>(*shaders_);
  }
  void TearDown() override {
    antialias_.reset();
    GraphTest::TearDown();
  }

  /// The thing's picture, its red in linear light, before and after. `solid`: that it is one.
  void draw(const Inside& inside, bool solid) {
    const gl::TextureDesc depth_desc{
        .format = GL_DEPTH_COMPONENT32F, .width = kWidth, .height = kHeight};
    const gl::Texture shown("shown", {.format = GL_RGBA8, .width = kWidth, .height = kHeight});
    const gl::Texture things("solid", depth_desc), depth("depth", depth_desc);
    std::vector<unsigned char> picture;
    std::vector<float> of_things;
    before.clear();
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const bool in = inside(x + 0.5, y + 0.5);
        const auto value =
            static_cast<unsigned char>(std::lround(255.0 * srgb(in ? kLight : kDark)));
        picture.insert(picture.end(), {value, value, value, 255});
        before.push_back(linear(static_cast<double>(static_cast<float>(value) / 255.0f)));
        of_things.push_back(in && solid ? 0.02f : 0.0f);
      }
    }
    shown.upload(GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
    things.upload(GL_DEPTH_COMPONENT, GL_FLOAT, of_things.data());
    const std::vector<float> all(of_things.size(), 0.01f);
    depth.upload(GL_DEPTH_COMPONENT, GL_FLOAT, all.data());
    graph_->begin_frame();
    const TextureId display = graph_->import(shown);
    antialias_->add(*graph_, graph_->import(things), graph_->import(depth), display);
    std::vector<float> seen;
    graph_->add(
        "read", [&](PassBuilder& pass) { pass.read(display).side_effect(); },
        [&](PassContext& context) { seen = context.texture(display).read_floats(4); });
    graph_->execute();
    after.clear();
    for (std::size_t i = 0; i < seen.size(); i += 4)
      after.push_back(linear(static_cast<double>(seen[i])));
  }

  /// Root of the mean squared distance to the light that each pixel would get of the thing's
  /// area, away from the picture's border, where edges end.
  double error(const std::vector<double>& picture, const Inside& inside) const {
    constexpr int kParts = 16, kBorder = 8;
    double squares = 0.0;
    for (int y = kBorder; y < kHeight - kBorder; ++y) {
      for (int x = kBorder; x < kWidth - kBorder; ++x) {
        int in = 0;
        for (int i = 0; i < kParts * kParts; ++i) {
          in += inside(x + (i % kParts + 0.5) / kParts, y + (i / kParts + 0.5) / kParts) ? 1 : 0;
        }
        const double exact = kDark + (kLight - kDark) * in / (kParts * kParts);
        const double off = picture[static_cast<std::size_t>(y * kWidth + x)] - exact;
        squares += off * off;
      }
    }
    return std::sqrt(squares / ((kWidth - 2.0 * kBorder) * (kHeight - 2.0 * kBorder)));
  }

  std::unique_ptr<Antialias> antialias_;
  std::vector<double> before, after;
};

TEST_F(AntialiasTest, AnEdgeComesNearToTheAreaOfItsPixels) {
  for (const double degrees : {3.0, 8.0, 20.0, 35.0, 55.0, 78.0, 86.0, 110.0, 165.0}) {
    const double angle = degrees * M_PI / 180.0;
    const bool steep =
        degrees > 30.0 && degrees < 60.0;  // steps of a pixel or two: no more is known
    const Inside half = [angle](double x, double y) {
      return (x - 48.3) * std::sin(angle) - (y - 32.2) * std::cos(angle) > 0.0;
    };
    draw(half, true);
    EXPECT_LT(error(after, half), (steep ? 0.65 : 0.42) * error(before, half))
        << degrees << " degrees";
  }
}

TEST_F(AntialiasTest, AWireThatIsThinnerThanAPixelLooksLessBroken) {
  for (const double degrees : {12.0, 33.0, 71.0}) {
    const double angle = degrees * M_PI / 180.0;
    const Inside wire = [angle](double x, double y) {
      return std::abs((x - 48.3) * std::sin(angle) - (y - 32.2) * std::cos(angle)) < 0.35;
    };
    draw(wire, true);
    EXPECT_LT(error(after, wire), 0.8 * error(before, wire)) << degrees << " degrees";
  }
}

TEST_F(AntialiasTest, WhatIsNoThingStaysAsItIs) {
  draw([](double x, double y) { return std::fmod(x * 7.0 + y * 3.0, 11.0) < 2.0; }, false);
  for (std::size_t i = 0; i < before.size(); ++i) ASSERT_NEAR(after[i], before[i], 1e-5) << i;
}

}  // namespace
}  // namespace offing
