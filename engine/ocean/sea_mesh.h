#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <limits>
#include <vector>

namespace offing {

inline constexpr double kEarthRadius = 6371.0e3;  ///< m

/// Which squares of sea to draw, and how finely. Squares of a quadtree that is fixed to the world
/// (so vertices never swim), each drawn as `cells` × `cells` of the same grid; a square is split
/// while its nearest point is closer than kReach times the side of its children. Between the last
/// sixth of that distance and its end the vertex shader moves odd vertices onto the coarser grid,
/// so that levels meet without a gap or a jump (Strugar 2010).
struct SeaMesh {
  // Squares of the next level can begin as far out as 1 + 2 sqrt(2) / kReach of a level's reach;
  // they must not have begun to morph there: that is at most 2 kMorph.
  static constexpr double kReach = 3.4;              ///< sides of a square up to which it is used
  static constexpr double kMorph = 0.92;             ///< share of that at which morphing starts
  static constexpr std::size_t kMostSquares = 8192;  ///< that are drawn at once
  static_assert(1.0 + 2.0 * 1.41422 / kReach <= 2.0 * kMorph);

  int cells = 8;                ///< per side of a square; even
  double finest_spacing = 0.4;  ///< m

  /// x, z of the corner relative to the camera (m), spacing (m), distance where morphing ends (m).
  using Square = glm::vec4;

  /// Squares within the view out to a little beyond the horizon. `eye` is x, z of the camera in the
  /// world, `height` its height above the mean level; waves stay within ±`amplitude` m. Nothing
  /// farther than `farthest` (m) is needed.
  std::vector<Square> select(glm::dvec2 eye, double height, double amplitude,
                             const glm::mat4& clip_from_relative,
                             double farthest = std::numeric_limits<double>::infinity()) const;

  /// Distance to the horizon over the ground, m.
  static double horizon(double height);
};

}  // namespace offing
