#pragma once
#include <glm/vec3.hpp>

#include <span>
#include <vector>

#include "game/frame/rigid_vertex.h"

namespace offing {

/// Points of a rope of this length (m) that hangs between a and b, `segments` + 1 of them. `down`
/// is a unit vector. Shorter than its span it is tight: a straight line.
std::vector<glm::vec3> hanging_rope(glm::vec3 a, glm::vec3 b, float length, glm::vec3 down,
                                    int segments = 14);

/// Adds a round line along the points, as the wires of the model are: radius in u.
void add_line(RigidMesh& mesh, std::span<const glm::vec3> points, float radius, int material);

}  // namespace offing
