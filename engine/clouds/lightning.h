#pragma once
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

/// The brightest flash of the view's moment.
FlashView flash_now(const RainCells& rain, const CloudView& view);

}  // namespace offing
