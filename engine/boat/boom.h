#pragma once

namespace offing {

/// The boom: a pendulum about the mast, free inside a sheet that can only pull. Tack and gybe, the
/// accidental one too, follow from it.
struct Boom {
  double angle = 0.0;  ///< rad, positive to starboard
  double rate = 0.0;   ///< rad/s

  /// One semi-implicit step under `torque` (N m). `sheet` is the widest angle the sheet allows.
  /// The limit takes the boom's momentum: a sheet does not bounce.
  void step(double torque, double inertia, double damping, double sheet, double dt) {
    rate = (rate + dt * torque / inertia) / (1.0 + dt * damping);
    angle += dt * rate;
    if (angle > sheet) {
      angle = sheet;
      if (rate > 0.0) rate = 0.0;
    } else if (angle < -sheet) {
      angle = -sheet;
      if (rate < 0.0) rate = 0.0;
    }
  }
};

}  // namespace offing
