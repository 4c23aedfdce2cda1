#pragma once
#include "engine/boat/boat.h"

namespace offing {

/// The boat as she settles on one course, calm water, steady wind, automatic trim, helmsman
/// steering.
struct SteadySailing {
  double speed = 0.0;    ///< m/s through the water, ahead; 0 where she cannot keep the course
  double vmg = 0.0;      ///< m/s toward the wind
  double heel = 0.0;     ///< rad, magnitude
  double leeway = 0.0;   ///< rad, magnitude
  double rudder = 0.0;   ///< rad, positive: weather helm (the rudder holds her off the wind)
  double twa = 0.0;      ///< rad, between wind and course, as sailed
  bool settled = false;  ///< the speed stood still within 0.2 % between two spans of 10 s
  long limit_hits = 0;
};

/// Sails `seconds` at most in `tws` m/s (at 10 m) at `twa` rad (0 to pi; positive from starboard,
/// negative from port) and averages the last 10 s. As in every velocity prediction `twa` lies
/// between the wind and the course through the water, so the bow points higher by the leeway.
SteadySailing sail_steadily(const R8Parameters& parameters, double tws, double twa,
                            double seconds = 120.0, double dt = 1.0 / 120.0);

/// Lever (m) of the moment that rights her at a heel (rad) in still water, crew amidships: hull and
/// keel at the depth where they carry her weight, trim kept level.
double righting_arm(const R8Parameters& parameters, double heel);

}  // namespace offing
