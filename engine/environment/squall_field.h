#pragma once
#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

namespace offing {

/// The wind that rain brings down. Under a cell cold air sinks with the rain, brings the faster
/// wind from aloft with it and flows out over the sea on all sides, with a front. One field, for
/// sails and for the look of the water; it lies on a periodic grid that moves with the rain.
class SquallField {
 public:
  /// Speed of the outflow of the heaviest rain, m/s: a density current k sqrt(g H dT/T) of 1 km of
  /// air 4 K colder, k = .75 (Wakimoto 1982).
  static constexpr double kOutflow = 8.6;
  /// The wind brought down over the wind at 10 m, less 1: half of what it blows faster at 700 m.
  static constexpr double kBroughtDown = 0.28;

  /// No rain.
  SquallField() = default;
  /// `rain` 0 to 1, size × size cells row by row, over `period` metres; `wind` the mean at 10 m.
  /// Throws nothing; a strength of 0 gives no squalls.
  SquallField(const std::vector<float>& rain, int size, double period, glm::dvec2 wind,
              double strength);

  bool any() const { return !added_.empty(); }
  int size() const { return size_; }
  double period() const { return period_; }
  /// What is added to the mean wind at 10 m, m/s; `place` counts from the grid's corner.
  glm::dvec2 added(glm::dvec2 place) const;
  /// The wind's speed over the mean's, less 1, cell by cell (cell (i, j) stands for (i + .5, j +
  /// .5) periods / size): what the water shows. Upload it as a repeating texture.
  const std::vector<float>& strength() const { return strength_; }

 private:
  int size_ = 0;
  double period_ = 1.0;
  std::vector<glm::dvec2> added_;
  std::vector<float> strength_;
};

}  // namespace offing
