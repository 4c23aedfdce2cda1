#include <cmath>
#include <vector>

#include "engine/core/angles.h"
#include "engine/gl/buffer.h"
#include "engine/gl/texture.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/clouds.h"
#include "shaders/shared/frame.h"
#include "shaders/shared/sky.h"
#include "support/adding_doubling.h"
#include "support/graph_test.h"

namespace offing {
namespace {

/// clouds/pathtrace.comp in an even layer of 100 m, seen from 1 m beside it, so that the air
/// between counts for nothing: light from all sides, from one side, and from a sun.
class CloudPathsTest : public test::GraphTest {
 protected:
  static constexpr int kSide = 64;                              // pixels, all of the same direction
  static constexpr float kThickness = 100.0f, kBase = 1000.0f;  // m
  static constexpr float kAir = 0.5f;                           // transmittance, any but 1

  struct Light {
    float above = 0.0f, below = 0.0f;  // radiance of all directions
    float sun = 0.0f;                  // illuminance across its way
    glm::vec3 toward_sun{0.0f, 1.0f, 0.0f};
  };

  struct Seen {
    double scattered = 0.0;  // mean radiance, all orders
    double met_none = 0.0;   // share of the paths
  };

  /// `cosine` of the eye's ray with the zenith: looking down at the layer from above where
  /// negative.
  Seen look(double depth, double g, double cosine, const Light& light, int samples) {
    shared::CloudData clouds{};
    const float eye = cosine < 0.0 ? kBase + kThickness + 1.0f : kBase - 1.0f;
    clouds.eye = {eye, 1.0e-12f, 1.0f, 0.0f};
    clouds.layer = {kBase, kBase + kThickness, static_cast<float>(depth) / kThickness, kBase};
    clouds.form = {0.0f, 0.0f, 0.0f, 1.0f};
    clouds.box = {0.0f, 0.0f, 1.0e8f, 0.0f};
    clouds.light_direction = glm::vec4(light.toward_sun, 0.0f);
    clouds.light_source = glm::vec4(glm::vec3(light.sun / kAir), 0.0f);
    clouds.light = {1.0f, 1.0f, 0.0f, 1.0f};
    clouds.phase = {static_cast<float>(g), 0.0f, 0.0f, 1.0f};
    clouds.ambient = {0.0f, 1.0f, 0.0f, 0.0f};
    clouds.shadow_light = {0.0f, 1.0f, 0.0f, 0.0f};
    shared::SkyData sky{};
    sky.sun_source = glm::vec4(light.above);
    sky.azimuths = {1.0f, 0.0f, 1.0f, 0.0f};
    sky.observer = {0.001f * eye, 0.0f, 1.0f, 0.0f};
    sky.aerosol = {0.0f, 0.0f, 1.0f, 0.0f};
    sky.lights.z = 1.0f;
    sky.table_texels = {2.0f, 1.0f, 2.0f, 1.0f};
    shared::FrameData frame{};
    const float sine = std::sqrt(1.0f - static_cast<float>(cosine * cosine));
    frame.relative_from_clip = glm::mat4(0.0f);
    frame.relative_from_clip[3] = {sine, static_cast<float>(cosine), 0.0f, 1.0f};
    // What comes up from the sea is .08 of what the sky sends down.
    frame.sky_illuminance = glm::vec4(static_cast<float>(kPi) * light.below / 0.08f);
    const gl::Buffer blocks[] = {{"frame", sizeof(frame), 0, &frame},
                                 {"sky", sizeof(sky), 0, &sky},
                                 {"clouds", sizeof(clouds), 0, &clouds}};
    blocks[0].bind_uniform(0);
    blocks[1].bind_uniform(OFFING_BIND_SKY);
    blocks[2].bind_uniform(OFFING_BIND_CLOUDS);
    const gl::Texture even = table("even sky", 1.0f), air = table("even air", kAir);
    even.bind(OFFING_UNIT_SKY_SUN);
    even.bind(OFFING_UNIT_SKY_MOON);
    air.bind(OFFING_UNIT_TRANSMITTANCE);
    const gl::Texture sum("paths", {.format = GL_RGBA32F, .width = kSide, .height = kSide});
    const gl::Texture distance("lengths", {.format = GL_RG32F, .width = kSide, .height = kSide});
    glClearTexImage(sum.id(), 0, GL_RGBA, GL_FLOAT, nullptr);
    glClearTexImage(distance.id(), 0, GL_RG, GL_FLOAT, nullptr);
    sum.bind_image(0, GL_READ_WRITE);
    distance.bind_image(1, GL_READ_WRITE);
    const ShaderProgram& program =
        shaders_->program({"clouds/pathtrace.comp"}, {{"EVEN_EXTINCTION", "1"},
                                                      {"STEPS", "1"},
                                                      {"SKIPS", "1"},
                                                      {"FINEST", "10.0"},
                                                      {"GROWTH", "0.0"},
                                                      {"REACH", "90000.0"}});
    program.use();
    program.program().set(0, glm::ivec2(0));
    for (int i = 0; i < samples; ++i) {
      program.program().set(1, glm::ivec2(first_++, 1));
      glDispatchCompute(kSide / 8, kSide / 8, 1);
      glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
    }
    const std::vector<float> values = sum.read_floats(4);
    Seen seen;
    for (std::size_t i = 0; i < values.size(); i += 4) {
      seen.scattered += static_cast<double>(values[i + 1]);
      seen.met_none += static_cast<double>(values[i + 3]);
    }
    const double share = 1.0 / (static_cast<double>(samples) * kSide * kSide);
    return {seen.scattered * share, seen.met_none * share};
  }

 private:
  static gl::Texture table(const char* label, float value) {
    gl::Texture texture(label, {.format = GL_RGBA32F, .width = 2, .height = 1});
    const float texels[8] = {value, value, value, 0.0f, value, value, value, 0.0f};
    texture.upload(GL_RGBA, GL_FLOAT, texels);
    return texture;
  }

  int first_ = 0;  // path that comes next: no two looks share their noise
};

TEST_F(CloudPathsTest, AnEvenLightStaysEven) {
  for (const double depth : {1.0, 20.0}) {
    for (const double cosine : {-0.8, 0.3}) {
      const Seen seen = look(depth, 0.85, cosine, {.above = 1.0f, .below = 1.0f}, 1);
      // Every path brings back 1, but for the lots that are drawn after forty turns.
      EXPECT_NEAR(seen.scattered + seen.met_none, 1.0, 0.02) << depth << " " << cosine;
    }
  }
}

// Under an even sky over black ground a slab sends back, toward an eye above it, what it would send
// back of a beam from there: its plane albedo. Toward an eye beneath it comes the rest.
TEST_F(CloudPathsTest, ASlabSendsBackWhatAddingAndDoublingSay) {
  const std::vector<double> cosines = {1.0, 0.4};
  for (const double g : {0.0, 0.85}) {
    for (const double depth : {1.0, 4.0, 16.0}) {
      const std::vector<double> albedo = test::slab_albedo(depth, g, cosines);
      for (std::size_t i = 0; i < cosines.size(); ++i) {
        const double c = cosines[i];
        const Seen above = look(depth, g, -c, {.above = 1.0f}, 2);
        const Seen beneath = look(depth, g, c, {.above = 1.0f}, 2);
        // The most that 8192 paths of 0 or 1 are off by, four standard deviations: .022.
        EXPECT_NEAR(above.scattered, albedo[i], 0.022) << g << " " << depth << " " << c;
        EXPECT_NEAR(beneath.scattered + beneath.met_none, 1.0 - albedo[i], 0.022)
            << g << " " << depth << " " << c;
        EXPECT_NEAR(above.met_none, std::exp(-depth / c), 0.022) << depth << " " << c;
      }
    }
  }
}

// Suns all over the sky make an even sky.
TEST_F(CloudPathsTest, SunsSumUpToASky) {
  constexpr int kAzimuths = 6;
  const test::Quadrature heights = test::gauss_legendre(6);
  for (const double g : {0.0, 0.6}) {
    for (const double depth : {1.0, 8.0}) {
      const double cosine = 0.7;
      const double albedo = test::slab_albedo(depth, g, {cosine})[0];
      // The sea sends back .05 of the suns' light; of that comes up what does not go straight.
      const double exact = albedo + 0.05 * (1.0 - albedo - std::exp(-depth / cosine));
      double sum = 0.0;
      for (std::size_t i = 0; i < heights.points.size(); ++i) {
        const double high = heights.points[i], flat = std::sqrt(1.0 - high * high);
        for (int a = 0; a < kAzimuths; ++a) {
          const double azimuth = kTau * (a + 0.5) / kAzimuths;
          const Light sun{
              .sun = 1.0f,
              .toward_sun = glm::vec3(flat * std::cos(azimuth), high, flat * std::sin(azimuth))};
          sum += kTau / kAzimuths * heights.weights[i] * look(depth, g, -cosine, sun, 1).scattered;
        }
      }
      EXPECT_NEAR(sum, exact, 0.01) << g << " " << depth;
    }
  }
}

}  // namespace
}  // namespace offing
