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

  /// Up to this age (s) samples are carried on from what is known; past it they are flattened.
  static constexpr double kLongestReach = 0.25;
  /// How long (s) flattening takes.
  static constexpr double kFlattening = 1.0;
  /// How far (s) `time` lies from what is known of the water: 0 where samples are as good as they
  /// get, infinite where nothing is known at all.
  virtual double age(double time) const;
  /// What is known is too old for `time`: the water is being flattened, or flat. Say so on screen.
  bool stale(double time) const { return age(time) > kLongestReach; }
};

/// The share of the water's motion that is left at an age (s): 1 up to kLongestReach, then falling
/// smoothly to 0 within kFlattening.
double share_left(double age);

/// Flat water at height 0.
class CalmWater final : public WaterSurface {
 public:
  void sample(std::span<const glm::dvec2> points, double time,
              std::span<WaterSample> out) const override;
};

}  // namespace offing
