#include <algorithm>
#include <cmath>

#include "engine/clouds/gardner_parameters.h"
#include "game/export/cloud_run.h"
#include "support/graph_test.h"

namespace offing {
namespace {

constexpr glm::ivec2 kSize{48, 27};

class CloudReferenceTest : public test::GlTest {
 protected:
  static FrameView view(std::vector<std::string> sets, glm::ivec2 size = kSize) {
    sets.insert(sets.begin(), {"camera.mode=free", "camera.position=0,4,0",
                               "camera.target=60,22,-80", "environment.time=13:00:00"});
    return still_view(make_scene("default", sets), size);
  }
  static double mean_light(const CloudSightings& clouds) {
    double sum = 0.0;
    for (const glm::vec4& light : clouds.light) sum += light.y;
    return sum / static_cast<double>(clouds.light.size());
  }
  static double mean_transmittance(const CloudSightings& clouds) {
    double sum = 0.0;
    for (const glm::vec4& light : clouds.light) sum += light.w;
    return sum / static_cast<double>(clouds.light.size());
  }
  /// Root of the mean squared difference: of the transmittance, and of the light over its mean.
  static glm::dvec2 error(const CloudSightings& exact, const CloudSightings& clouds) {
    glm::dvec2 squares(0.0);
    for (std::size_t i = 0; i < exact.light.size(); ++i) {
      const glm::dvec4 off = glm::dvec4(clouds.light[i]) - glm::dvec4(exact.light[i]);
      squares += glm::dvec2(off.w * off.w, off.y * off.y);
    }
    const glm::dvec2 root = glm::sqrt(squares / static_cast<double>(exact.light.size()));
    return {root.x, root.y / mean_light(exact)};
  }
};

TEST_F(CloudReferenceTest, TheMarchComesNearToItsReferenceAndBetterWithQuality) {
  CloudRun low(CloudQuality::of(0)), ultra(CloudQuality::of(3));
  // Light beyond its few steps is a guess at each place, right in the mean; a low sun's way is
  // longest.
  const struct {
    const char* time;
    double of_ultra, of_low;
  } most[] = {{"13:00:00", 0.27, 0.5}, {"19:00:00", 0.30, 0.55}};
  for (const auto& limit : most) {
    const std::string at = std::string("environment.time=") + limit.time;
    const FrameView day = view({at});
    const CloudSightings exact = ultra.reference(day);
    for (int i = 0; i < 66; ++i) low.march(day);  // one of a cell's 32 pixels at a time, twice
    ultra.march(day);
    const CloudSightings by_low = low.marched(day), by_ultra = ultra.marched(day);
    const glm::dvec2 of_low = error(exact, by_low), of_ultra = error(exact, by_ultra);
    EXPECT_GT(mean_light(exact), 100.0);
    EXPECT_LT(of_ultra.x, 0.02);
    EXPECT_LT(of_ultra.y, limit.of_ultra) << limit.time;
    EXPECT_NEAR(mean_light(by_ultra) / mean_light(exact), 1.0, 0.05) << limit.time;
    EXPECT_LT(of_low.y, limit.of_low) << limit.time;
    EXPECT_NEAR(mean_light(by_low) / mean_light(exact), 1.0, 0.1) << limit.time;
    EXPECT_LT(of_ultra.x, of_low.x);
    EXPECT_LT(of_ultra.y, of_low.y);
  }
}

TEST_F(CloudReferenceTest, WhatWasSeenAboveLeavesNothingBeneathTheHorizon) {
  const FrameView up = view({"camera.target=60,90,-80", "environment.clouds.cover=0.9"});
  const FrameView level = view({"camera.target=60,4,-80", "environment.clouds.cover=0.9"});
  for (const int quality : {0, 3}) {
    CloudRun run(CloudQuality::of(quality));
    for (int frame = 0; frame < 4; ++frame) run.march(up);
    for (int frame = 0; frame < 4; ++frame) run.march(level);
    const CloudSightings seen = run.marched(level);
    for (int i = 0; i < kSize.x * (kSize.y / 2 - 1); ++i)
      ASSERT_EQ(seen.light[static_cast<std::size_t>(i)], glm::vec4(0, 0, 0, 1)) << quality << i;
    EXPECT_LT(mean_transmittance(seen), 0.9);
  }
}

TEST_F(CloudReferenceTest, TheLightModelComesNearToThePathTracer) {
  CloudRun run(CloudQuality::of(3));
  // High sun and low; the paths' noise is some hundredths of the mean.
  for (const char* time : {"13:00:00", "19:00:00"}) {
    const FrameView day = view({std::string("environment.time=") + time}, {32, 18});
    const CloudSightings model = run.reference(day), traced = run.path_trace(day, 32);
    // Where the cloud is thick for both: the reference smooths noise to the width of a pixel, here
    // 100 m at 5 km, which thins out edges. A path either meets a cloud or does not: only the mean
    // is free of that noise.
    double of_model = 0.0, of_traced = 0.0;
    int thick = 0;
    for (std::size_t i = 0; i < model.light.size(); ++i) {
      if (model.light[i].w > 0.1f || traced.light[i].w > 0.1f) continue;
      of_model += model.light[i].y;
      of_traced += traced.light[i].y;
      ++thick;
    }
    EXPECT_GT(thick, 30);
    EXPECT_NEAR(of_model / of_traced, 1.0, 0.1) << time;
    EXPECT_NEAR(mean_transmittance(model), mean_transmittance(traced), 0.05);
  }
}

class GardnerTileTest : public test::GraphTest {};

TEST_F(GardnerTileTest, HoldsTheTextureFunction) {
  constexpr int kTexels = 128;
  const GardnerParameters parameters;
  const gl::Texture tile("tile", {.format = GL_R16, .width = kTexels, .height = kTexels});
  const ShaderProgram& program = shaders_->program({"clouds/gardner_tile.comp"});
  program.use();
  program.program().set(0, parameters.terms);
  program.program().set(1, static_cast<float>(parameters.contrast));
  tile.bind_image(0, GL_WRITE_ONLY);
  glDispatchCompute(kTexels / 8, kTexels / 8, 1);
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
  const std::vector<float> values = tile.read_floats(1);
  // The sum of sines itself, in double: Gardner 1985, (3) to (6), for samples 2 / kTexels apart.
  for (int y = 3; y < kTexels; y += 17) {
    for (int x = 5; x < kTexels; x += 13) {
      const double u = 2.0 * (x + 0.5) / kTexels, v = 2.0 * (y + 0.5) / kTexels;
      double sum_x = 0.0, sum_y = 0.0, most = 0.0;
      for (int i = 0; i < parameters.terms; ++i) {
        const double waves = std::exp2(i), strength = std::pow(0.707, i), tau = 2.0 * M_PI;
        const double keep = std::clamp(2.0 - 4.0 * waves * 2.0 / kTexels, 0.0, 1.0);
        sum_x +=
            strength * (keep * std::sin(tau * waves * u + M_PI / 2.0 * std::sin(M_PI * waves * v)) +
                        parameters.contrast);
        sum_y +=
            strength * (keep * std::sin(tau * waves * v + M_PI / 2.0 * std::sin(M_PI * waves * u)) +
                        parameters.contrast);
        most += strength * (1.0 + parameters.contrast);
      }
      EXPECT_NEAR(values[static_cast<std::size_t>(y * kTexels + x)], sum_x * sum_y / (most * most),
                  2e-4);
    }
  }
}

}  // namespace
}  // namespace offing
