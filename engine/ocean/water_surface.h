#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <span>

namespace offing {

/// The water at one place and time.
struct WaterSample {
  double height = 0.0;               ///< metres above the mean level
  glm::dvec3 normal{0.0, 1.0, 0.0};  ///< unit, out of the water
  glm::dvec3 velocity{0.0};          ///< m/s of the water itself (orbital), at the surface
};

/// Something that can be asked where the water is. Knows no OpenGL.
class WaterSurface {
 public:
  virtual ~WaterSurface() = default;
  /// One sample per horizontal point (x, z in metres, world), at `time` (s, the sea's clock).
  /// Safe from any thread, never waits. `out` has the length of `points`.
  virtual void sample(std::span<const glm::dvec2> points, double time,
                      std::span<WaterSample> out) const = 0;
};

/// Flat water at height 0.
class CalmWater final : public WaterSurface {
 public:
  void sample(std::span<const glm::dvec2> points, double time,
              std::span<WaterSample> out) const override;
};

}  // namespace offing
