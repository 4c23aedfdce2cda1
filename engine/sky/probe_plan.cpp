#include "engine/sky/probe_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/core/angles.h"
#include "shaders/shared/probe.h"

#define OFFING_GLSL "shaders/lib/probe.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

using glm::dvec3;

// A node counts whole where the lobe is all but a straight line across it: the most by which it may
// bend, as a share of the lobe's light. Wide lobes are sums of large nodes, and of fewer; of narrow
// ones, which see few texels, more is allowed.
double tolerance_of(double alpha) {
  return 4e-3 * std::pow(0.06 / alpha, alpha > 0.06 ? 1.3 : 0.5);
}

struct Node {
  dvec3 middle;
  double angle;   // solid angle, sr
  double extent;  // from the middle to the farthest corner, along the chord
};

/// The nodes of all mips.
struct Tree {
  int size;
  std::array<std::vector<Node>, ProbePlan::kMips> mips;

  explicit Tree(int s) : size(s) {
    std::vector<Node>& texels = mips[0];
    const double last = s - 1.0;
    for (int y = 0; y < s; ++y) {
      for (int x = 0; x < 2 * s; ++x) {
        const int column = x % s;
        // The solid angle that a texel stands for; of those on the edges half lies outside.
        double angle = 0.0;
        for (int i = 0; i < 16; ++i) {
          const glsl::vec2 part((column + (i % 4) * 0.25 - 0.375) / last,
                                (y + (i / 4) * 0.25 - 0.375) / last);
          const bool inside = std::min(part.x, part.y) >= 0.0 && std::max(part.x, part.y) <= 1.0;
          if (inside) angle += glsl::probe_solid_angle(part) / (16.0 * last * last);
        }
        texels.push_back({direction(column, y, s, x < s), angle, 0.0});
      }
    }
    for (std::size_t mip = 1; mip < mips.size(); ++mip) {
      const int side = s >> mip;
      for (int y = 0; y < side; ++y) {
        for (int x = 0; x < 2 * side; ++x) mips[mip].push_back(parent(mip, x, y));
      }
    }
  }

  static dvec3 direction(int column, int row, int side, bool upper) {
    const glsl::vec2 units(column / (side - 1.0), row / (side - 1.0));
    return glm::normalize(dvec3(glsl::probe_direction(units, upper ? 1.0 : -1.0)));
  }

  const Node& at(std::size_t mip, int x, int y) const {
    return mips[mip][static_cast<std::size_t>(y) * static_cast<std::size_t>(2 * size >> mip) +
                     static_cast<std::size_t>(x)];
  }

  Node parent(std::size_t mip, int x, int y) const {
    dvec3 middle(0.0);
    Node node{};
    for (int i = 0; i < 4; ++i) {
      const Node& child = at(mip - 1, 2 * x + i % 2, 2 * y + i / 2);
      middle += child.angle * child.middle;
      node.angle += child.angle;
    }
    node.middle = glm::normalize(middle);
    for (int i = 0; i < 4; ++i) {
      const Node& child = at(mip - 1, 2 * x + i % 2, 2 * y + i / 2);
      node.extent = std::max(node.extent, glm::length(child.middle - node.middle) + child.extent);
    }
    return node;
  }
};

/// The texels of a level for which one list is made.
struct Tile {
  dvec3 middle;
  double extent;  // along the chord
  double alpha;   // width of the lobe
  double tolerance;
};

Tile tile_of(int side, int first_x, int first_y, bool upper, double alpha) {
  std::vector<dvec3> directions;
  dvec3 sum(0.0);
  for (int y = first_y; y < std::min(first_y + ProbePlan::kTile, side); ++y) {
    for (int x = first_x; x < std::min(first_x + ProbePlan::kTile, side); ++x) {
      directions.push_back(Tree::direction(x, y, side, upper));
      sum += directions.back();
    }
  }
  Tile tile{glm::normalize(sum), 0.0, alpha, tolerance_of(alpha)};
  for (const dvec3& d : directions) {
    tile.extent = std::max(tile.extent, glm::length(d - tile.middle));
  }
  return tile;
}

void collect(const Tree& tree, const Tile& tile, std::size_t mip, int x, int y,
             std::vector<std::uint32_t>& list) {
  const Node& node = tree.at(mip, x, y);
  const double distance = glm::length(node.middle - tile.middle) - tile.extent;
  // Behind all of the tile's surfaces: a chord of more than the square root of 2.
  if (distance - node.extent > std::sqrt(2.0)) return;
  const double near = std::max(distance, 0.0);
  // The share of the lobe that it makes out at most (probe_level.comp), and how far the lobe is
  // from a straight line across it.
  const double a2 = tile.alpha * tile.alpha, cosine = 1.0 - 0.5 * near * near;
  const double a = a2 * (1.0 + cosine) + 1.0 - cosine, t = 4.0 / kPi * a2 * node.angle;
  const double r = std::sqrt(a * a + t), share = 0.5 * t / (r * (r + a));
  const double edge = std::max(distance - node.extent, 0.0);  // there it bends most
  const double bend = node.extent * node.extent / (4.0 * a2 + edge * edge);
  if (mip == 0 || share * bend < tile.tolerance) {
    list.push_back(static_cast<std::uint32_t>(
        x + (y + ProbePlan::first_row(tree.size, static_cast<int>(mip))) * 65536));
    return;
  }
  for (int i = 0; i < 4; ++i) collect(tree, tile, mip - 1, 2 * x + i % 2, 2 * y + i / 2, list);
}

}  // namespace

ProbePlan::ProbePlan(int size, const std::vector<int>& sides) {
  const Tree tree(size);
  const auto width = static_cast<std::size_t>(2 * size);
  places.assign(width * width, glm::vec4(0.0f));
  for (int mip = 0; mip < kMips; ++mip) {
    const int side = size >> mip;
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < 2 * side; ++x) {
        const Node& node = tree.at(static_cast<std::size_t>(mip), x, y);
        places[static_cast<std::size_t>(first_row(size, mip) + y) * width +
               static_cast<std::size_t>(x)] = glm::vec4(glm::dvec4(node.middle, node.angle));
      }
    }
  }
  constexpr int kRoot = kMips - 1;
  // A place below all nodes: it has no solid angle, and so no weight.
  const auto none = static_cast<std::uint32_t>((2 * size - 1) * 65536);
  for (std::size_t level = 0; level < sides.size(); ++level) {
    const int side = sides[level];
    const double alpha = glsl::probe_alpha(static_cast<double>(level));
    if (level == 1) first_sum = static_cast<int>(tiles.size());
    for (int y = 0; y < side; y += kTile) {
      for (int x = 0; x < side; x += kTile) {
        for (const bool upper : {true, false}) {
          const std::size_t first = lists.size();
          if (level > 0) {
            const Tile tile = tile_of(side, x, y, upper, alpha);
            for (int j = 0; j < size >> kRoot; ++j) {
              for (int i = 0; i < 2 * size >> kRoot; ++i) {
                collect(tree, tile, kRoot, i, j, lists);
              }
            }
            lists.resize((lists.size() + 3) / 4 * 4, none);
          }
          tiles.emplace_back(first / 4, (lists.size() - first) / 4, level,
                             x | y << 12 | (upper ? 0 : 1) << 24);
        }
      }
    }
  }
}

}  // namespace offing
