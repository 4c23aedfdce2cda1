#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "engine/boat/rigid_body.h"

namespace offing {

/// Places and sizes of R8's sails, boat frame, metres.
struct RigParameters {
  double main_area = 20.0, jib_area = 14.0;  ///< m^2
  double mast_top = 11.2;                    ///< m above the waterline
  double mast_z = -0.6;
  double main_height = 5.05, jib_height = 3.95;  ///< of the centres of effort
  double main_chord = 1.45;                      ///< from mast to the main's centre of effort
  double jib_tack_z = -3.7;
  double jib_chord = 1.9;      ///< from tack to the jib's centre of effort
  double boom_inertia = 30.0;  ///< kg m^2 about the mast
  double boom_damping = 2.6;   ///< 1/s
  double boom_moment = 18.0;   ///< kg m: its weight times the arm
  double boom_least = 0.017;   ///< rad, 1 degree: the traveller hauled to windward
  double boom_stop = 1.4835;   ///< rad, 85 degrees: the shrouds
  double jib_least = 0.140;    ///< rad, 8 degrees: its tracks lie on the coachroof
  double jib_stop = 1.31;      ///< rad, 75 degrees
};

/// How the sails are set now.
struct SailSet {
  double main_angle = 0.0;  ///< rad, boom, positive to starboard
  double jib_angle = 0.0;   ///< rad, the jib's chord
  double flat = 1.0;        ///< 0.42 to 1: how full the sails are cut
  double reef = 1.0;        ///< 0.4 to 1: linear size of both sails
  bool hoisted = true;
};

/// One sail at work.
struct SailReading {
  double attack = 0.0;            ///< rad, flow against chord; positive pushes to starboard
  double lift = 0.0, drag = 0.0;  ///< coefficients, without the rig's induced drag
  double fill = 0.0;   ///< -1 to 1: how hard and to which side the belly is pressed, + starboard
  double luff = 0.0;   ///< 0 full to 1 shaking
  double stall = 0.0;  ///< 0 attached to 1 stalled though it could be eased
};

/// Both sails at work.
struct RigReading {
  SailReading main, jib;
  double boom_torque = 0.0;  ///< N m of the wind on the boom, positive pushes to starboard
};

/// Lift and drag of one sail whose best-sheeted coefficients are known against the apparent wind.
/// `angle` of the flow in the boat's plane (rad, 0 from ahead, positive blowing to starboard),
/// `sheeted` the chord's angle, `stop` the angle it cannot pass. `jib` picks the table.
SailReading sail_coefficients(bool jib, double angle, double sheeted, double stop, double flat);

/// The wind in the sails.
///
/// Coefficients of main and jib: ORC VPP 2023, section 5, for the best sheeting; off it, lift
/// follows a sine up to 22 degrees of attack and gives way to a flat plate beyond, except where the
/// boom lies on its stop. Induced drag is that of the whole rig, once. The flow is taken in the
/// plane square to the mast, so heel enters by geometry.
class Rig {
 public:
  explicit Rig(const RigParameters& parameters) : p_(parameters) {}
  const RigParameters& parameters() const { return p_; }

  glm::dvec3 main_centre(const SailSet& set) const;
  glm::dvec3 jib_centre(const SailSet& set) const;
  /// Adds the loads about `centre` (boat frame). Winds: apparent, m/s, boat axes, at both centres.
  RigReading add_loads(Loads& loads, const SailSet& set, const glm::dvec3& centre,
                       const glm::dvec3& main_wind, const glm::dvec3& jib_wind) const;

 private:
  RigParameters p_;
};

}  // namespace offing
