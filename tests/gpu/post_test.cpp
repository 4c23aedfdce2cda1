#include <cmath>
#include <limits>

#include "engine/graph/gl_device.h"
#include "engine/post/tonemap.h"
#include "support/gl_test.h"

namespace offing {
namespace {

class PostTest : public test::GlTest {
 protected:
  /// The display values (0 to 255) of an HDR picture of 64 × 4 pixels.
  std::vector<float> show(const std::vector<float>& pixels, const TonemapSettings& settings,
                          std::uint32_t* nonfinite = nullptr) {
    ShaderLibrary shaders(data_root() / "shaders");
    Tonemap tonemap(shaders);
    GlDevice device;
    FrameGraph graph(device);
    const gl::Texture hdr("hdr", {.format = GL_RGBA16F, .width = 64, .height = 4});
    const gl::Texture out("out", {.format = GL_RGBA8, .width = 64, .height = 4});
    hdr.upload(GL_RGBA, GL_FLOAT, pixels.data());
    graph.begin_frame();
    const TextureId shown = graph.import(out);
    tonemap.add(graph, graph.import(hdr), shown, settings);
    graph.add(
        "show", [&](PassBuilder& pass) { pass.read(shown).side_effect(); }, [](PassContext&) {});
    graph.execute();
    if (nonfinite != nullptr) {
      *nonfinite = tonemap.take_nonfinite_pixels();
      EXPECT_EQ(tonemap.take_nonfinite_pixels(), 0u);  // taken
    }
    std::vector<float> values = out.read_floats(4);
    for (float& value : values) value *= 255.0f;
    return values;
  }
  static std::vector<float> even(float value) { return std::vector<float>(64 * 4 * 4, value); }
};

constexpr double kDay = 1e-5;  // an exposure at which no rods see

TEST_F(PostTest, ExponentialCurveThenSrgbWithinTheDither) {
  for (float x : {0.01f, 0.25f, 1.0f, 3.0f}) {
    const double linear = 1.0 - std::exp(-static_cast<double>(x));
    const double srgb =
        255.0 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055);
    double mean = 0.0;
    const auto values = show(even(x), {.curve = ToneCurve::kExponential, .exposure = kDay});
    for (std::size_t i = 0; i < values.size(); i += 4) {
      EXPECT_NEAR(values[i], srgb, 1.1) << x;
      mean += values[i] / static_cast<double>(values.size() / 4);
    }
    EXPECT_NEAR(mean, srgb, 0.15) << x;  // the dither keeps what rounding would lose
  }
}

TEST_F(PostTest, CountsAndBlackensWhatIsNotFinite) {
  std::vector<float> pixels = even(0.5f);
  pixels[4 * 5] = std::numeric_limits<float>::quiet_NaN();
  pixels[4 * 70 + 1] = std::numeric_limits<float>::infinity();
  pixels[4 * 200 + 2] = -std::numeric_limits<float>::infinity();
  std::uint32_t count = 0;
  const auto values = show(pixels, {.exposure = kDay}, &count);
  EXPECT_EQ(count, 3u);
  EXPECT_LE(values[4 * 5 + 1], 1.0f);
  EXPECT_GT(values[4 * 6 + 1], 100.0f);
}

TEST_F(PostTest, MoonlightLosesItsColoursAndDaylightDoesNot) {
  std::vector<float> red = even(0.0f);
  for (std::size_t i = 0; i < red.size(); i += 4) red[i] = 0.3f;
  const auto day = show(red, {.exposure = kDay});
  const auto night = show(red, {.exposure = 100.0});  // 0.0006 cd/m^2
  EXPECT_GT(day[0], 100.0f);
  EXPECT_LT(day[2], 40.0f);
  EXPECT_LT(night[0], 0.7f * day[0]);
}

}  // namespace
}  // namespace offing
