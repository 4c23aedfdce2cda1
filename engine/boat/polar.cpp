#include "engine/boat/polar.h"

#include <algorithm>
#include <cmath>

#include "engine/boat/hydrostatics.h"
#include "engine/core/angles.h"

namespace offing {

SteadySailing sail_steadily(const R8Parameters& parameters, double tws, double twa, double seconds,
                            double dt) {
  Boat boat(parameters);
  const CalmWater water;
  const SteadyWind wind(tws, 0.0);
  boat.start({0.0, 0.0}, -twa, std::min(0.4 * tws, 2.5), water, 0.0);
  boat.hold_heading_at(-twa);

  constexpr double kWindow = 10.0, kDriftTime = 3.0, kMostDrift = radians(20.0);
  SteadySailing mean;
  const int window = std::max(1, static_cast<int>(std::lround(kWindow / dt)));
  const int windows = std::max(2, static_cast<int>(seconds / kWindow));
  const double side = twa < 0.0 ? -1.0 : 1.0;
  double last_speed = -1.0;
  double drift = 0.0;
  for (int w = 0; w < windows; ++w) {
    mean = SteadySailing{};
    bool recovered = false;
    double slowest = 1e9, fastest = -1e9;
    for (int i = 0; i < window; ++i) {
      boat.step(water, wind, dt * (w * window + i), dt);
      const Navigation& n = boat.navigation();
      recovered = recovered || boat.recovering();
      // The course through the water is what lies at `twa`: the bow points higher by the leeway.
      drift += (std::clamp(n.leeway, -kMostDrift, kMostDrift) - drift) * (dt / kDriftTime);
      boat.hold_heading_at(-twa - drift);
      slowest = std::min(slowest, n.stw);
      fastest = std::max(fastest, n.stw);
      mean.speed += n.stw / window;
      mean.vmg += n.vmg / window;
      mean.heel += std::abs(n.heel) / window;
      mean.leeway += std::abs(n.leeway) / window;
      mean.twa += (twa + wrap_pi(n.twa - n.leeway - twa)) / window;
      // Weather helm: she wants up, to the side of the wind; the rudder holds her off.
      mean.rudder -= side * boat.state().rudder_angle / window;
    }
    mean.limit_hits = boat.limit_hits();
    // Pinched too high she luffs, stops, bears away and tries again: that is no sailing.
    constexpr double kOffCourse = radians(2.0);
    // Nor is losing way, before she stops.
    const bool keeps_way = w == 0 || mean.speed > 0.97 * last_speed;
    const bool steady = !recovered && keeps_way && std::abs(wrap_pi(mean.twa - twa)) < kOffCourse &&
                        fastest - slowest < 0.08 * std::abs(mean.speed) + 0.01;
    const double sailed = mean.speed;
    if (!steady) mean.speed = mean.vmg = 0.0;
    mean.settled = steady && std::abs(mean.speed - last_speed) <= 0.002 * mean.speed + 1e-4;
    if (mean.settled && w >= 3) break;
    last_speed = sailed;
  }
  return mean;
}

double righting_arm(const R8Parameters& p, double heel) {
  const HullShape hull = keelboat(p.lines);
  const double volume = p.mass / kWaterDensity;
  double low = -5.0, high = 5.0, arm = 0.0;  // height of the water over the origin
  for (int i = 0; i < 60; ++i) {
    const double height = 0.5 * (low + high);
    const Immersion m = immerse_heeled(hull, heel, height);
    const double wet =
        std::clamp(0.5 + (height - p.keel_place.y * std::cos(heel)) / p.keel_span, 0.0, 1.0);
    const double keel = wet * p.keel_volume;
    (m.volume + keel < volume ? low : high) = height;
    const double x = m.volume * m.centroid.x;
    const double y = m.volume * m.centroid.y + keel * p.keel_place.y;
    arm = (x * std::cos(heel) + y * std::sin(heel)) / (m.volume + keel) -
          p.centre_of_gravity.y * std::sin(heel);
  }
  return arm;
}

}  // namespace offing
