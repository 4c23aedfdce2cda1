#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "shaders/shared/bindings.h"
#include "shaders/shared/ocean.h"
#include "support/graph_test.h"
#include "support/paths.h"

namespace offing {
namespace {

class HullShade : public test::GraphTest {};

// Beside a wall's shadow with its straight edge the light that enters beyond it reaches the eye's
// ray at every depth below s / t: exp(-2 K s / t) of the glow, s metres from the edge, t the rays'
// drift by depth.
TEST_F(HullShade, BesideAWallIsWhatComesFromBelowTheShadowsEdge) {
  constexpr std::size_t kPlaces = 64;
  const ShaderProgram& program =
      shaders_->program({test::test_data() / "data/shaders/hull_shade.comp"}, {});
  const glm::dvec3 loss(0.35, 0.08, 0.03);  // 1/m
  shared::OceanData ocean{};
  ocean.hull_loss = glm::vec4(loss, 0.0);
  const gl::Buffer block("ocean", sizeof(ocean));
  block.write(ocean);
  const gl::Buffer out("kept", kPlaces * sizeof(glm::vec4), 0);
  const double high = std::sin(0.7), low = std::cos(0.7);  // sun 40 degrees high, view down at 50
  const glm::dvec3 light(low, high, 0.0), view(-high, low, 0.0);
  const double index = 1.34;
  const auto drift = [index](double sine) { return std::tan(std::asin(sine / index)); };
  const double t = drift(low) + drift(high);

  const double last = 20.0 * t;
  program.use();
  block.bind_uniform(OFFING_BIND_OCEAN);
  out.bind_storage(1);
  program.program().set(0, glm::vec4(view, -last));
  program.program().set(1, glm::vec4(light, last / kPlaces));
  glDispatchCompute(1, 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  std::vector<glm::vec4> kept(kPlaces);
  out.read(kept.data(), kPlaces * sizeof(glm::vec4));
  for (std::size_t i = 0; i < kPlaces; ++i) {
    const double depth = 20.0 * (1.0 - static_cast<double>(i) / kPlaces);
    for (int c = 0; c < 3; ++c) {
      // Between two depths the shader knows straight lines.
      EXPECT_NEAR(kept[i][c], std::exp(-2.0 * loss[c] * depth), 0.065)
          << depth << " m, colour " << c;
    }
  }
}

}  // namespace
}  // namespace offing
