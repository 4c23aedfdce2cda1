#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace offing {

/// Which parts of what the probe sees each of its texels is a sum over, known once and for all: a
/// tree of nodes (texels, and squares of 2 to 32 of them), and for each tile of a level
/// the nodes that look small from there beside its lobe (after Barnes & Hut, Nature 1986).
struct ProbePlan {
  static constexpr int kMips = 6;  ///< sizes of nodes: 1, 2, 4, 8, 16 and 32 texels per side
  static constexpr int kTile = 8;  ///< texels per side of a tile

  /// `size`: texels per side of each of the two squares of what is seen, a multiple of 32;
  /// `sides`: texels per side of the levels, of which the first, a mirror, is no sum.
  ProbePlan(int size, const std::vector<int>& sides);

  /// Place of the first node of a mip among all: x is 0, row y. All nodes lie in one picture,
  /// 2 × size wide and high, in each mip the upper square's and right of them the lower's.
  static int first_row(int size, int mip) { return 2 * size - (2 * size >> mip); }

  /// Of each node: xyz its middle (unit), w its solid angle, sr; 0 where no node is.
  std::vector<glm::vec4> places;
  /// Nodes by lists, each x + 65536 y; each list is filled up to a multiple of 4 by a place without
  /// a node.
  std::vector<std::uint32_t> lists;
  /// The levels' texels in squares of kTile, level by level. x, y: the first of its list and how
  /// many, both in fours (none for level 0); z: level; w: its first column and row in the level's
  /// square and whether that is the lower one, by bits 0, 12 and 24 (shaders/sky/probe_tile.glsl).
  std::vector<glm::uvec4> tiles;
  int first_sum = 0;  ///< the first tile of level 1
};

}  // namespace offing
