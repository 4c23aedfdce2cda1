#pragma once
#include <glm/vec3.hpp>
#include <vector>

namespace offing {

/// The sky with the physics of its tables (light scattered once, and more often as if alike in all
/// directions: Hillaire 2020, §5.5), integrated in double until finer steps change nothing: what
/// the tables would hold without their sizes and steps. Of the code that draws it shares the
/// constants of the air (aerosol_of_haze(), air_at(), phase functions), no geometry and no table.
/// Bands and units as in AirReference; the light is an even disc of the sun's size.
class AirIntegral {
 public:
  /// `fineness` multiplies all sizes and steps; twice as fine takes up to 32 times as long.
  explicit AirIntegral(double haze, double fineness = 1.0);

  /// Radiance toward `view`, which must not meet the sea, for a light at `light` (units, y up).
  glm::dvec3 radiance(double height_km, const glm::dvec3& view, const glm::dvec3& light) const;

 private:
  /// Even in the root of the height and in the signed root of an angle (radians) between two ends.
  struct Table {
    int heights = 0, angles = 0;
    double below = 0.0, above = 0.0;  ///< where the angle begins (as a positive number) and ends
    std::vector<glm::dvec3> values;   ///< logarithms

    double height(int row) const;
    double angle(int column) const;
    glm::dvec3 at(double height_km, double angle) const;
  };

  int finely(int count) const;
  glm::dvec3 light_at(double height_km, double cosine) const;
  glm::dvec3 often_scattered(double height_km, double elevation) const;

  double haze_;
  double fineness_;
  Table depth_;  ///< optical depth to the top of the air, by the angle above the sea's horizon
  Table often_;  ///< radiance of light scattered more than once, by the light's elevation
};

}  // namespace offing
