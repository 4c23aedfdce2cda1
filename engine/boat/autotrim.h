#pragma once
#include "engine/boat/parameters.h"

namespace offing {

/// What a crew sees when it trims.
struct TrimView {
  double apparent = 0.0;  ///< rad, flow at the main in the boat's plane, 0 from ahead
  double wind = 0.0;      ///< m/s, its speed
  double leeway = 0.0;    ///< rad
  double heel = 0.0;      ///< rad
  double speed = 0.0;     ///< m/s ahead through the water
  double turn = 0.0;      ///< -1 to 1: where whoever steers wants the bow, + starboard
};

/// Sheets and depowering a crew would choose.
struct TrimOrder {
  double main_sheet = 0.0;  ///< rad, widest angle of the boom
  double jib_sheet = 0.0;   ///< rad
  double flat = 1.0;
  double reef = 1.0;
  double jib_aback = 0.0;  ///< 0, or the side the clew is held to: -1 port, +1 starboard
};

/// Trims both sails for 22 degrees of attack, with as much sail as the wind allows her to carry;
/// past 26 degrees of heel flattens, then reefs, and spills wind from the main in gusts; eases
/// while she slides sideways with a stalled keel; head to wind without way, backs the jib to turn
/// the bow.
class AutoTrim {
 public:
  void reset() { *this = AutoTrim{}; }
  /// `reef_most` is the largest linear size the sails may have.
  TrimOrder step(const RigParameters& rig, const TrimView& view, double reef_most, double dt);

 private:
  bool started_ = false;
  double apparent_ = 0.6, wind_ = 0.0, heel_ = 0.0, power_ = 1.0, stuck_ = 0.0;
};

}  // namespace offing
