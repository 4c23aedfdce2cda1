#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace offing {

/// As boat/rigid.vert reads it.
struct RigidVertex {
  glm::vec3 position, normal;
  glm::vec2 uv;  ///< of a wire: its radius (m), 0
  float material;
};

/// Triangles of rigid parts.
struct RigidMesh {
  std::vector<RigidVertex> vertices;
  std::vector<std::uint32_t> indices;
};

}  // namespace offing
