#pragma once

namespace offing {

/// What a helmsman sees.
struct HelmView {
  double heading = 0.0;       ///< rad from north, clockwise
  double turn_rate = 0.0;     ///< rad/s, clockwise
  double speed = 0.0;         ///< m/s ahead through the water
  double leeway = 0.0;        ///< rad
  double wind_from = 0.0;     ///< rad, true wind
  double free_rudder = 0.0;   ///< rad, where the rudder would stream in the water, + to starboard
  double rudder_most = 0.61;  ///< rad, the angle of a helm of 1
};

/// Steers: holds a heading, or takes her through the wind and holds the other tack. When she has
/// lost her way near the wind, or slides sideways on a stalled keel, bears away first to get it
/// back. Feels a stalling rudder and gives no more of it.
class Helmsman {
 public:
  enum class Task { kNone, kHold, kTack, kGybe };

  Task task() const { return task_; }
  double target() const { return target_; }
  /// True while she bears away to get going again.
  bool recovering() const { return task_ != Task::kNone && recovering_; }
  void release() { task_ = Task::kNone; }
  void hold(double heading);
  /// Tacks where the true wind is ahead of the beam, gybes where it is abaft, onto the same angle
  /// on the other side, kept within 42 to 60 and 135 to 165 degrees.
  void tack_or_gybe(const HelmView& view);
  /// Where the bow is to go, -1 to 1, + starboard: the rudder while she goes ahead, its opposite
  /// astern.
  double step(const HelmView& view, double dt);

 private:
  double wanted(const HelmView& view, double dt);

  Task task_ = Task::kNone;
  bool recovering_ = false;
  double target_ = 0.0, integral_ = 0.0, turn_ = 0.0;
};

}  // namespace offing
