#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>

#include "engine/boat/hull_shape.h"
#include "engine/boat/rigid_body.h"
#include "engine/ocean/water_surface.h"

namespace offing {

/// The water round one slice of a hull: a plane, and how the water moves.
struct SliceWater {
  glm::dvec3 centre{0.0};    ///< world; the point of the slice on the boat's long axis
  double height = 0.0;       ///< m, of the water above `centre`'s horizontal place
  glm::dvec2 slope{0.0};     ///< d height / d (x, z), world
  glm::dvec3 velocity{0.0};  ///< m/s, world, orbital

  /// Height of the water above a world point.
  double above(const glm::dvec3& p) const {
    return height + slope.x * (p.x - centre.x) + slope.y * (p.z - centre.z) - p.y;
  }
};

/// Asks the water at two points abreast of every slice (of slices closer than half a metre: at
/// stations that far apart), once a step, and keeps what the hull needs.
/// A sample that is not a number or beyond any sea (40 m high, 30 m/s, flatter than upright by more
/// than 80 degrees) is replaced by the last good one, or cut, and counted: hostile water gives odd
/// motion for a moment, never a NaN.
class WaterProbe {
 public:
  static constexpr int kMostSlices = 16;

  /// `origin` is the world place of the boat's origin. dt > 0.
  void sample(const HullShape& shape, const glm::dvec3& origin, const glm::dquat& orientation,
              const WaterSurface& water, double time, double dt);
  /// Forget the past: the next sample starts afresh.
  void reset();

  const SliceWater& slice(int i) const { return slices_[i]; }
  /// The slice nearest to a place along the boat.
  const SliceWater& at(const HullShape& shape, double z) const;
  double mean_height() const { return mean_height_; }
  glm::dvec2 mean_slope() const { return mean_slope_; }
  const glm::dvec3& mean_velocity() const { return mean_velocity_; }
  /// Of the water along the hull, m/s^2: across from the slope (deep water: a = -g grad h), up from
  /// the change of its speed between steps, smoothed over 0.1 s.
  const glm::dvec3& mean_acceleration() const { return mean_acceleration_; }
  /// How much of the surface's orbital motion is left at a depth (m): exp(-k depth) with the wave
  /// number g <slope^2> / <velocity^2> of the last seconds, which is exact for one deep-water wave.
  double left_at(double depth) const;
  /// How the upward acceleration grows toward the stern, 1/s^2 (d a_y / dz along the hull), got and
  /// smoothed as the mean's is.
  double pitch_acceleration() const { return pitch_acceleration_; }
  /// How fast the surface turns about the boat's long axis, rad/s, positive lifts starboard.
  double roll_rate() const { return roll_rate_; }
  /// Samples replaced or cut since the start.
  long limits() const { return limits_; }

 private:
  WaterSample checked(const WaterSample& sample, int index);

  std::array<SliceWater, kMostSlices> slices_{};
  std::array<glm::dvec2, 2 * kMostSlices> points_{};
  std::array<WaterSample, 2 * kMostSlices> samples_{}, good_{};
  glm::dvec3 mean_velocity_{0.0}, mean_acceleration_{0.0};
  glm::dvec2 mean_slope_{0.0};
  double mean_height_ = 0.0, roll_rate_ = 0.0, vertical_acceleration_ = 0.0;
  double pitch_rate_ = 0.0, pitch_acceleration_ = 0.0;
  double slope_energy_ = 0.0, velocity_energy_ = 0.0;
  bool started_ = false;
  long limits_ = 0;
};

}  // namespace offing
