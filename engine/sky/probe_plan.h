#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace offing {

/// Which parts of what the probe sees each of its texels is a sum over, known once and for all: a
/// tree of nodes (texels, and squares of 2 to 16 of them), and for each block of texels of a level
/// the nodes that look small from there beside its lobe (after Barnes & Hut, Nature 1986).
struct ProbePlan {
  static constexpr int kMips = 5;     ///< sizes of nodes: 1, 2, 4, 8 and 16 texels per side
  static constexpr int kColumns = 8;  ///< of a block's texels
  static constexpr int kRows = 8;

  /// `size`: texels per side of each of the two squares of what is seen, a multiple of 16;
  /// `sides`: texels per side of the levels, of which the first, a mirror, has no blocks.
  ProbePlan(int size, const std::vector<int>& sides);

  /// Place of the first node of a mip among all: x is 0, row y. All nodes lie in one picture,
  /// 2 × size wide and high, in each mip the upper square's and right of them the lower's.
  static int first_row(int size, int mip) { return 2 * size - (2 * size >> mip); }

  /// Of each node: xyz its middle (unit), w its solid angle, sr; 0 where no node is.
  std::vector<glm::vec4> places;
  /// Nodes by lists, each x + 65536 y; each list is filled up to a multiple of 4 by a place without
  /// a node.
  std::vector<std::uint32_t> lists;
  /// Of each block its list: x the first, y how many, both in fours. Level by level, block row by
  /// block row, and in each place that of the upper square and that of the lower.
  std::vector<glm::uvec2> blocks;
  std::vector<int> first_block;  ///< of each level

  static int blocks_across(int side) { return (side + kColumns - 1) / kColumns; }
  static int block_rows(int side) { return (side + kRows - 1) / kRows; }
};

}  // namespace offing
