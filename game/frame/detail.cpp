#include "game/frame/detail.h"

#include <meshoptimizer.h>

namespace offing {

DetailLevels add_detail_levels(std::span<const RigidVertex> vertices,
                               std::vector<std::uint32_t>& indices, std::uint32_t first) {
  constexpr std::size_t kStride = sizeof(RigidVertex);
  const std::vector<std::uint32_t> finest(indices.begin() + first, indices.end());
  indices.resize(first);
  const float* positions = &vertices.front().position.x;
  const float scale = meshopt_simplifyScale(positions, vertices.size(), kStride);
  DetailLevels levels;
  for (std::size_t level = 0; level < levels.size(); ++level) {
    std::vector<std::uint32_t> coarse = finest;
    if (kDetailErrors[level] > 0.0f) {
      coarse.resize(meshopt_simplify(coarse.data(), finest.data(), finest.size(), positions,
                                     vertices.size(), kStride, 0, kDetailErrors[level] / scale));
    }
    meshopt_optimizeVertexCache(coarse.data(), coarse.data(), coarse.size(), vertices.size());
    levels[level] = {static_cast<std::uint32_t>(indices.size()),
                     static_cast<std::uint32_t>(coarse.size())};
    indices.insert(indices.end(), coarse.begin(), coarse.end());
  }
  return levels;
}

int detail_level(float distance, float pixel) {
  int level = 0;
  for (std::size_t i = 0; i < kDetailErrors.size(); ++i) {
    if (kDetailErrors[i] <= 0.5f * distance * pixel) level = static_cast<int>(i);
  }
  return level;
}

}  // namespace offing
