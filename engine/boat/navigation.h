#pragma once
#include <string_view>

namespace offing {

enum class PointOfSail {
  kHeadToWind,
  kCloseHauled,
  kCloseReach,
  kBeamReach,
  kBroadReach,
  kRunning
};

/// Why she does not go as she could.
enum class Trouble {
  kNone,
  kCapsized,
  kNoWind,
  kSailsDown,
  kInIrons,
  kGoingAstern,
  kAback,
  kLuffing,
  kStalled,
  kOverpowered,
};

/// What the instruments and a sailor's eye say. SI and radians; headings from north clockwise, wind
/// directions where it comes from, wind angles -pi to pi, positive from starboard.
struct Navigation {
  double sog = 0.0, cog = 0.0;  ///< over the ground
  double heading = 0.0;
  double stw = 0.0;                        ///< ahead through the water, negative astern
  double leeway = 0.0;                     ///< through the water, positive drifts to starboard
  double tws = 0.0, twd = 0.0, twa = 0.0;  ///< true wind at 10 m
  double aws = 0.0, awa = 0.0;             ///< apparent wind at the masthead
  double vmg = 0.0;                        ///< toward the true wind, m/s
  double heel = 0.0;                       ///< positive to starboard
  double pitch = 0.0;                      ///< positive bow up
  double turn_rate = 0.0;                  ///< rad/s, positive to starboard
  PointOfSail point = PointOfSail::kBeamReach;
  Trouble trouble = Trouble::kNone;
  bool water_is_late = false;  ///< she sails on what was last known of the sea
};

PointOfSail point_of_sail(double twa);
/// "close-hauled"
std::string_view name(PointOfSail point);
/// "in irons"; empty for none.
std::string_view name(Trouble trouble);
/// One sentence that says what to do, without jargon; empty for none.
std::string_view advice(Trouble trouble);

}  // namespace offing
