#include "game/frame/detail.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

#include "engine/core/angles.h"

namespace offing {
namespace {

/// A ball of 1 m radius, `n` rows of 2n columns.
RigidMesh ball(int n) {
  RigidMesh mesh;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j < 2 * n; ++j) {
      const double down = kPi * i / n, round = kPi * j / n;
      const glm::vec3 p(std::sin(down) * std::cos(round), std::cos(down),
                        std::sin(down) * std::sin(round));
      mesh.vertices.push_back({p, p, glm::vec2(0.0f), 0.0f});
    }
  }
  const auto at = [n](int i, int j) { return static_cast<std::uint32_t>(2 * n * i + j % (2 * n)); };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < 2 * n; ++j) {
      mesh.indices.insert(mesh.indices.end(), {at(i, j), at(i + 1, j), at(i, j + 1)});
      mesh.indices.insert(mesh.indices.end(), {at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)});
    }
  }
  return mesh;
}

TEST(Detail, EachLevelHasFewerTrianglesAndStaysByTheSurface) {
  RigidMesh mesh = ball(64);
  const auto finest = static_cast<std::uint32_t>(mesh.indices.size());
  const DetailLevels levels = add_detail_levels(mesh.vertices, mesh.indices, 0);
  EXPECT_EQ(levels[0].count, finest);
  for (std::size_t level = 1; level < levels.size(); ++level) {
    EXPECT_LT(levels[level].count, levels[level - 1].count) << level;
    EXPECT_GT(levels[level].count, 60u) << level;
    // A flat face lies inside the ball, the most in its middle.
    float deepest = 0.0f;
    for (std::uint32_t i = 0; i < levels[level].count; i += 3) {
      glm::vec3 middle(0.0f);
      for (std::uint32_t k = 0; k < 3; ++k) {
        middle += mesh.vertices[mesh.indices[levels[level].first + i + k]].position / 3.0f;
      }
      deepest = std::max(deepest, 1.0f - glm::length(middle));
    }
    // The quadric's error is a mean over the faces that met there: the worst place has twice as
    // much.
    EXPECT_LT(deepest, 2.0f * kDetailErrors[level] + 0.001f) << level;
  }
}

TEST(Detail, ErrorsStayUnderHalfAPixel) {
  constexpr float kPixel = 0.001f;
  EXPECT_EQ(detail_level(0.0f, kPixel), 0);
  for (float distance = 0.5f; distance < 1000.0f; distance *= 1.3f) {
    const auto level = static_cast<std::size_t>(detail_level(distance, kPixel));
    EXPECT_LE(kDetailErrors[level] / distance, 0.5f * kPixel) << distance;
  }
  EXPECT_EQ(detail_level(1000.0f, kPixel), static_cast<int>(kDetailErrors.size()) - 1);
}

}  // namespace
}  // namespace offing
