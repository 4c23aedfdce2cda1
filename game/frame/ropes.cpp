#include "game/frame/ropes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace offing {

std::vector<glm::vec3> hanging_rope(glm::vec3 a, glm::vec3 b, float length, glm::vec3 down,
                                    int segments) {
  std::vector<glm::vec3> points;
  const glm::vec3 span = b - a;
  const float drop = glm::dot(span, down);
  const glm::vec3 level = span - drop * down;
  const float across = std::max(glm::length(level), 0.02f), direct = glm::length(span);
  // Catenary y = c cosh(x / c): sqrt(length^2 - drop^2) = 2 c sinh(across / 2c). With r = across /
  // 2c sinh(r) / r is known; Newton from its series.
  const float slack = std::sqrt(std::max(length * length - drop * drop, 0.0f)) / across;
  float r = 0.0f;
  if (length > 1.0005f * direct && slack > 1.0f) {
    r = slack < 3.0f ? std::sqrt(6.0f * (slack - 1.0f)) : std::log(2.0f * slack) + 1.0f;
    for (int i = 0; i < 8; ++i) {
      r -= (std::sinh(r) - slack * r) / std::max(std::cosh(r) - slack, 1e-4f);
      r = std::clamp(r, 1e-3f, 12.0f);
    }
  }
  const float c = r > 1e-3f ? across / (2.0f * r) : 0.0f;
  // The lowest point lies nearer to the lower end.
  const float lowest =
      c > 0.0f ? 0.5f * across + c * std::asinh(drop / (2.0f * c * std::sinh(r))) : 0.0f;
  for (int i = 0; i <= segments; ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(segments);
    glm::vec3 point = a + t * span;
    if (c > 0.0f) {
      const float hangs = c * (std::cosh(lowest / c) - std::cosh((t * across - lowest) / c));
      point += (hangs - t * drop) * down;
    }
    points.push_back(point);
  }
  return points;
}

void add_line(RigidMesh& mesh, std::span<const glm::vec3> points, float radius, int material) {
  constexpr std::uint32_t kSides = 4;
  const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::vec3 way =
        glm::normalize(points[std::min(i + 1, points.size() - 1)] - points[i == 0 ? 0 : i - 1]);
    const glm::vec3 other =
        std::abs(way.y) < 0.9f ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(1.0f, 0.0f, 0.0f);
    const glm::vec3 side = glm::normalize(glm::cross(way, other)), up = glm::cross(side, way);
    for (std::uint32_t k = 0; k < kSides; ++k) {
      const float angle = 1.5707963f * static_cast<float>(k);
      const glm::vec3 normal = std::cos(angle) * side + std::sin(angle) * up;
      mesh.vertices.push_back(
          {points[i] + radius * normal, normal, {radius, 0.0f}, static_cast<float>(material)});
    }
  }
  for (std::uint32_t i = 0; i + 1 < points.size(); ++i) {
    for (std::uint32_t k = 0; k < kSides; ++k) {
      const std::uint32_t a = base + i * kSides + k, b = base + i * kSides + (k + 1) % kSides;
      mesh.indices.insert(mesh.indices.end(), {a, b, a + kSides, b, b + kSides, a + kSides});
    }
  }
}

}  // namespace offing
