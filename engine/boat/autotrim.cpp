#include "engine/boat/autotrim.h"

#include <algorithm>
#include <cmath>

#include "engine/boat/hydrostatics.h"
#include "engine/core/angles.h"

namespace offing {
namespace {

/// How much sail (0 to 1, as `power` below) she can carry close-hauled in an apparent wind: full
/// sail at best lift against what holds her upright at 26 degrees, crew out.
double power_for(const RigParameters& rig, double wind) {
  constexpr double kRightingMoment = 11500.0, kBestLift = 1.4, kArmBelow = 0.75;  // N m, -, m
  const double area = std::max(rig.main_area + rig.jib_area, 1e-3);
  const double height =
      (rig.main_area * rig.main_height + rig.jib_area * rig.jib_height) / area + kArmBelow;
  const double full = 0.5 * kAirDensity * wind * wind * area * kBestLift * height;
  const double part = kRightingMoment / std::max(full, 1.0);
  // Flattened all the way she has 0.5 of the moment left, reefed all the way 0.13.
  return part > 0.5 ? 0.5 + (part - 0.5) : std::max(0.0, 0.5 * (part - 0.13) / 0.37);
}

}  // namespace

TrimOrder AutoTrim::step(const RigParameters& rig, const TrimView& view, double reef_most,
                         double dt) {
  constexpr double kBestAttack = radians(22.0), kMostHeel = radians(26.0);
  constexpr double kEye = 2.0, kFeel = 1.0;  // s: how fast the crew notices
  if (!started_) {
    apparent_ = std::abs(view.apparent);
    wind_ = view.wind;
  }
  apparent_ += (std::abs(view.apparent) - apparent_) * (dt / (dt + kEye));
  heel_ += (std::abs(view.heel) - heel_) * (dt / (dt + kFeel));

  wind_ += (view.wind - wind_) * (dt / (dt + 2.0));
  const double ahead = std::cos(std::min(apparent_, 0.5 * kPi));  // off the wind she carries more
  const double most = std::min(1.0, 1.15 * power_for(rig, wind_ * (0.5 + 0.5 * ahead)));
  if (!started_) power_ = most;
  started_ = true;

  const double excess = heel_ - kMostHeel;
  constexpr double kEase = 1.0, kReturn = 0.6;  // per rad of heel and second
  power_ = std::clamp(power_ - excess * (excess > 0.0 ? kEase : kReturn) * dt, 0.0, most);

  TrimOrder order;
  constexpr double kFlattest = 0.55, kSmallest = 0.6;
  order.flat = kFlattest + (1.0 - kFlattest) * std::clamp(2.0 * power_ - 1.0, 0.0, 1.0);
  order.reef = std::min(reef_most, kSmallest + (1.0 - kSmallest) * std::min(2.0 * power_, 1.0));
  // A gust heels her faster than anyone reefs: spill it.
  const double spill = std::clamp(std::abs(view.heel) - kMostHeel - radians(4.0), 0.0, 0.35);
  // Sliding sideways under press, she goes ahead again with less of it. Upright she only drifts.
  const double press = std::clamp(std::abs(view.heel) / radians(12.0), 0.0, 1.0);
  const double slide =
      press * std::clamp(std::abs(view.leeway) - radians(12.0), 0.0, radians(45.0));
  // The main aft of the mast holds her up to the wind, the more the more she heels, and the rudder
  // is no match for it while she has no way close to the wind: ease it to bear away.
  const double way = std::clamp((1.2 - view.speed) / 0.7, 0.0, 1.0);
  const double near = std::clamp((radians(65.0) - apparent_) / radians(20.0), 0.0, 1.0);
  const double away = std::max(view.apparent < 0.0 ? -view.turn : view.turn, 0.0);
  const double bear_away = std::max(press, way * near) * radians(25.0) * std::max(away - 0.2, 0.0);
  order.main_sheet = std::clamp(apparent_ - kBestAttack + spill + slide + bear_away, rig.boom_least,
                                rig.boom_stop);
  order.jib_sheet = std::clamp(apparent_ - kBestAttack, rig.jib_least, rig.jib_stop);

  const bool in_irons = view.speed < 0.5 && apparent_ < radians(24.0);
  stuck_ = in_irons ? stuck_ + dt : 0.0;
  if (stuck_ > 1.0) {
    // The bow falls away from the side the clew is held to. No helm: fall off as she lies.
    const double wish = std::abs(view.turn) > 0.1 ? view.turn : view.apparent;
    order.jib_aback = wish < 0.0 ? 1.0 : -1.0;
    order.main_sheet = radians(45.0);  // free, it no longer holds her bow to the wind
  }
  return order;
}

}  // namespace offing
