#include "engine/boat/helmsman.h"

#include <algorithm>
#include <cmath>

#include "engine/core/angles.h"

namespace offing {

void Helmsman::hold(double heading) {
  if (task_ == Task::kNone) integral_ = 0.0;
  task_ = Task::kHold;
  target_ = wrap_tau(heading);
}

void Helmsman::tack_or_gybe(const HelmView& view) {
  const double angle = wrap_pi(view.wind_from - view.heading);  // positive: from starboard
  const double side = angle < 0.0 ? -1.0 : 1.0;
  const bool ahead = std::abs(angle) < 0.5 * kPi;
  const double other = ahead ? std::clamp(std::abs(angle), radians(42.0), radians(60.0))
                             : std::clamp(std::abs(angle), radians(135.0), radians(165.0));
  hold(view.wind_from + side * other);
  task_ = ahead ? Task::kTack : Task::kGybe;
  turn_ = ahead ? side : -side;
}

double Helmsman::step(const HelmView& view, double dt) {
  if (task_ == Task::kNone) return 0.0;
  const double helm = wanted(view, dt);
  if (view.speed < 0.2) return helm;
  // Beyond its stall a rudder brakes more than it turns.
  constexpr double kMostAttack = radians(17.0);
  const double low = std::clamp((view.free_rudder - kMostAttack) / view.rudder_most, -1.0, 1.0);
  const double high = std::clamp((view.free_rudder + kMostAttack) / view.rudder_most, -1.0, 1.0);
  return std::clamp(helm, low, high);
}

double Helmsman::wanted(const HelmView& view, double dt) {
  const double wind = wrap_pi(view.wind_from - view.heading);
  const double stalled = radians(25.0), flowing = radians(9.0);
  if (std::abs(wind) > radians(100.0) || (view.speed > 1.3 && std::abs(view.leeway) < flowing)) {
    recovering_ = false;
  } else if (std::abs(wind) < radians(75.0) &&
             (view.speed < 0.35 || (view.speed < 1.5 && std::abs(view.leeway) > stalled))) {
    recovering_ = true;
    task_ = Task::kHold;
  }
  double goal = target_;
  if (recovering_) goal = view.wind_from - (wind < 0.0 ? -1.0 : 1.0) * radians(85.0);
  const double error = wrap_pi(goal - view.heading);
  if (task_ != Task::kHold) {
    constexpr double kMeet = 0.45;  // rad before the new heading where the helm is met
    const bool there = std::abs(error) < kMeet + 0.4 * std::abs(view.turn_rate);
    if (!there) return 0.55 * turn_;
    task_ = Task::kHold;
  }
  // The rudder's moment grows with the square of the speed: so does the helm with slowness.
  const double ease = std::clamp(3.0 / std::max(std::abs(view.speed), 0.1), 0.5, 2.0);
  if (std::abs(error) < 0.35) {
    integral_ = std::clamp(integral_ + 0.25 * error * dt, -0.35, 0.35);
  }
  return std::clamp(ease * (1.8 * error - 1.2 * view.turn_rate) + integral_, -1.0, 1.0);
}

}  // namespace offing
