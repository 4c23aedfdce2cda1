#include "engine/boat/autotrim.h"

#include <algorithm>
#include <cmath>

#include "engine/core/angles.h"

namespace offing {

TrimOrder AutoTrim::step(const RigParameters& rig, const TrimView& view, double reef_most,
                         double dt) {
  constexpr double kBestAttack = radians(22.0), kMostHeel = radians(26.0);
  constexpr double kEye = 0.6, kFeel = 1.0;  // s: how fast the crew notices
  apparent_ += (std::abs(view.apparent) - apparent_) * (dt / (dt + kEye));
  heel_ += (std::abs(view.heel) - heel_) * (dt / (dt + kFeel));

  const double excess = heel_ - kMostHeel;
  constexpr double kEase = 1.0, kReturn = 0.6;  // per rad of heel and second
  power_ = std::clamp(power_ - excess * (excess > 0.0 ? kEase : kReturn) * dt, 0.0, 1.0);

  TrimOrder order;
  constexpr double kFlattest = 0.55, kSmallest = 0.6;
  order.flat = kFlattest + (1.0 - kFlattest) * std::clamp(2.0 * power_ - 1.0, 0.0, 1.0);
  order.reef = std::min(reef_most, kSmallest + (1.0 - kSmallest) * std::min(2.0 * power_, 1.0));
  // A gust heels her faster than anyone reefs: spill it.
  const double spill = std::clamp(std::abs(view.heel) - kMostHeel - radians(4.0), 0.0, 0.35);
  order.main_sheet = std::clamp(apparent_ - kBestAttack + spill, rig.boom_least, rig.boom_stop);
  order.jib_sheet = std::clamp(apparent_ - kBestAttack, rig.jib_least, rig.jib_stop);

  const bool in_irons = std::abs(view.speed) < 0.5 && apparent_ < radians(24.0);
  stuck_ = in_irons ? stuck_ + dt : 0.0;
  if (stuck_ > 1.0) {
    // The bow falls away from the side the clew is held to. No helm: fall off as she lies.
    const double wish = std::abs(view.turn) > 0.1 ? view.turn : view.apparent;
    order.jib_aback = wish < 0.0 ? 1.0 : -1.0;
  }
  return order;
}

}  // namespace offing
