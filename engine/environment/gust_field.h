#pragma once
#include <glm/vec2.hpp>

#include <vector>

namespace offing {

/// The gusts: one frozen pattern of wind strength over the sea, the same for sails and for the look
/// of the water. Mean 0 and variance 1, periodic, with von Kármán's spectrum (length 150 m)
/// smoothed over a 3 s gust at 10 m/s. The wind carries it along (Taylor's hypothesis).
class GustField {
 public:
  static constexpr int kSize = 512;     ///< cells a side
  static constexpr double kCell = 8.0;  ///< metres
  static constexpr double kPeriod = kSize * kCell;
  /// Turbulence intensity at gusts = 1: standard deviation of the wind over its mean. The 3 s gust
  /// of ten minutes then is about 1.25 times the mean, as measured over the open sea.
  static constexpr double kIntensity = 0.086;

  GustField();

  /// Between the cells' centres bilinearly, as a texture unit would. Any finite position (metres).
  double at(glm::dvec2 position) const;

  /// Row by row: cell (column i, row j) stands for x = (i + 0.5) kCell, z = (j + 0.5) kCell. Upload
  /// it as one repeating kSize × kSize texture.
  const std::vector<float>& grid() const { return grid_; }

 private:
  std::vector<float> grid_;
};

/// The one pattern there is; made at the first call (some 10 ms), never changed.
const GustField& gust_field();

}  // namespace offing
