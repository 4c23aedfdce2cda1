#pragma once
#include <glm/vec3.hpp>

#include <vector>

#include "engine/clouds/rain_cells.h"

namespace offing {

/// One flash of lightning inside a cloud: a few strokes from one place. All of it follows from the
/// seed and the clock, so it is the same forward, backward and after a jump.
struct Flash {
  static constexpr double kLongest = 0.9;  ///< s from the first stroke until nothing shows

  double begin = 0.0;     ///< on the clock that clouds run by, s
  glm::dvec2 at{0.0};     ///< on the weather map, in periods
  double height = 0.0;    ///< over the bases, share of the tallest cloud
  std::uint64_t key = 0;  ///< what its strokes are drawn from

  /// Luminous intensity (cd) at a time: strokes that fade in some tens of milliseconds.
  double candela(double time) const;
};

/// The flashes that begin from `from` to before `until` (s). A Poisson process: as many a minute as
/// CloudEffects::lightning in 100 km² of a full-grown storm, in proportion to how much of one
/// stands there. None without a rate, and nothing is worked out then.
std::vector<Flash> flashes(const RainCells& rain, const CloudView& view, double from, double until);

/// The flash that sends the most light here at the view's moment; other clouds show no other.
FlashView flash_now(const RainCells& rain, const CloudView& view);

/// Where the view's flash is, relative to the eye (m), the wind having drawn the cloud's top along.
glm::dvec3 flash_place(const CloudView& view);

/// A flash as it lights what is outside its cloud.
struct FlashLight {
  glm::dvec3 direction{0.0, 1.0, 0.0};  ///< toward it, unit
  double spread = 0.0;  ///< 1 - cosine of half the angle over which its cloud glows; 0: none
  glm::dvec3 illuminance{0.0};  ///< lux at the eye on a surface facing it
};

/// The light of the view's flash at the eye, through air of this extinction at sea level (1/m). A
/// cloud takes none of it: it comes as from the channel alone, but from all of the cloud about it.
FlashLight flash_light(const CloudView& view, const glm::dvec3& extinction);

}  // namespace offing
