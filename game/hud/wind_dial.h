#pragma once

namespace offing {

/// What the wind dial shows. Angles in rad relative to the bow, positive to starboard, of where the
/// wind comes from; speeds in knots.
struct DialReading {
  double apparent_angle = 0.0, apparent_knots = 0.0;
  double true_angle = 0.0, true_knots = 0.0;
  double boom_angle = 0.0;  ///< of the boom's end from astern, positive to starboard
  double jib_angle = 0.0;
  double rudder_angle = 0.0;  ///< of the rudder's trailing edge from astern, positive to starboard
};

/// Draws the boat from above with the wind round her, into the current ImGui window.
void draw_wind_dial(const DialReading& reading, float radius);

}  // namespace offing
