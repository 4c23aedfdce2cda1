#pragma once
#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

#include "engine/clouds/cloud_view.h"

namespace offing {

/// Where it rains, known to the CPU: a coarse twin of the weather map's rain, for the wind that
/// comes down with it. A picture of the user's rains only on the GPU.
class RainCells {
 public:
  static constexpr int kSize = 128;      ///< cells a side of one period of the weather
  static constexpr double kStep = 10.0;  ///< s of the clock between two states

  /// Brings the cells to the view's clock; true where they have changed. Without precipitation
  /// there are none and nothing is worked out.
  bool update(const CloudView& view);

  /// Rain, 0 to 1, at a place on the weather map (in periods) at a time (s); 0 before any update().
  double at(const CloudView& view, double elapsed, glm::dvec2 place) const;

  bool any() const { return !rain_.empty(); }
  /// 0 to 1, row by row, from the corner on.
  const std::vector<float>& rain() const { return rain_; }
  /// Side of the grid, m.
  double period() const { return period_; }
  /// Of the grid's corner in the world (x, z; m), where its rain reaches the sea now.
  glm::dvec2 corner(const CloudView& view) const;
  /// The middle of a cell in the world, the nearest to the view's eye of all its repetitions.
  glm::dvec2 middle(const CloudView& view, std::size_t cell) const;

 private:
  std::vector<std::uint8_t> patterns_;  ///< the weather map's, at its own size
  std::vector<float> rain_;
  double period_ = 1.0;
  std::uint64_t key_ = 0;
};

}  // namespace offing
