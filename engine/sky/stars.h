#pragma once
#include <glm/vec4.hpp>

#include <vector>

namespace offing {

/// One star as stars.vert reads it.
struct StarVertex {
  glm::vec4 direction_magnitude;  ///< equatorial unit vector, visual magnitude
  glm::vec4 tint;                 ///< linear sRGB of luminance 1
};

/// A sky like ours though not ours: as many stars of each magnitude (to 6.0) as there are, gathered
/// toward the plane of the galaxy, with their range of colours. Always the same.
std::vector<StarVertex> make_stars();

}  // namespace offing
