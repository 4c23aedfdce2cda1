#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "engine/boat/autotrim.h"
#include "engine/boat/boom.h"
#include "engine/boat/deck_water.h"
#include "engine/boat/foil.h"
#include "engine/boat/helmsman.h"
#include "engine/boat/hull.h"
#include "engine/boat/navigation.h"
#include "engine/boat/parameters.h"
#include "engine/boat/rig.h"
#include "engine/boat/rigid_body.h"
#include "engine/boat/water_probe.h"
#include "engine/boat/wind_field.h"
#include "engine/ocean/water_surface.h"

namespace offing {

/// What a player holds. Values out of range are cut, values that are not numbers count as 0.
struct BoatControls {
  /// -1 bow to port (A) to +1 bow to starboard (D), self-centring. Going astern the wheel is turned
  /// the other way for it.
  double rudder = 0.0;
  double mainsheet = 0.3;  ///< 0 in to 1 out; automatic trim keeps it up to date
  double jib_sheet = 0.2;  ///< 0 in to 1 out
  int reef = 0;            ///< 0 to 3
  double motor = 0.0;      ///< -1 to 1
  bool auto_trim = true;
  bool sails_up = true;
  bool crew_hikes = true;  ///< the crew sits out to windward
};

/// Everything that is drawn and interpolated. Angles in rad; body axes x to starboard, y up, z aft.
struct BoatState {
  glm::dvec3 position{0.0};  ///< world, of the model's origin: amidships on the design waterline
  glm::dquat orientation{1.0, 0.0, 0.0, 0.0};  ///< world from boat
  glm::dvec3 velocity{0.0};                    ///< m/s, world, of the centre of mass
  glm::dvec3 angular_velocity{0.0};            ///< rad/s, boat axes
  double boom_angle = 0.0;                     ///< positive to starboard
  double boom_rate = 0.0;                      ///< rad/s
  double jib_angle = 0.0;                      ///< positive to starboard
  double rudder_angle = 0.0;  ///< positive: trailing edge, and so the bow, to starboard
  double mainsheet = 0.0, jib_sheet = 0.0;       ///< 0 in to 1 out, as they are
  double flat = 1.0, reef = 1.0;                 ///< fullness and linear size of the sails
  double crew_offset = 0.0;                      ///< m to starboard
  double main_fill = 0.0, jib_fill = 0.0;        ///< -1 to 1: press of wind, + bellies to starboard
  double main_stall = 0.0, jib_stall = 0.0;      ///< 0 attached to 1 stalled
  double main_luff = 0.0, jib_luff = 0.0;        ///< 0 full to 1 shaking
  double deck_water = 0.0, cockpit_water = 0.0;  ///< m^3 shipped and not yet run off
  glm::dvec3 apparent_wind{0.0};  ///< m/s, boat axes, at the main: how the air moves past her
};

/// The state between two states, t = 0 to 1, for drawing.
BoatState interpolate(const BoatState& a, const BoatState& b, double t);

/// Forces of the last step, N, boat axes.
struct BoatForces {
  glm::dvec3 buoyancy{0.0}, sails{0.0}, keel{0.0}, rudder{0.0}, windage{0.0};
  double resistance = 0.0;  ///< along her way, positive slows
  double slam = 0.0;        ///< N, upward, of the slices that go in
  double volume = 0.0;      ///< m^3 under water, keel included
};

/// R8: a six-degrees-of-freedom keelboat on queried water, in a queried wind. Knows no OpenGL,
/// keeps no clock, allocates nothing per step, and gives the same states for the same inputs.
class Boat {
 public:
  /// Throws InputError where a number is impossible.
  explicit Boat(const R8Parameters& parameters = {});

  /// Puts her afloat at a place (x, z), at rest on the surface there, under way at `speed` m/s
  /// along `heading` (rad). Forgets everything before; keeps the controls.
  void start(glm::dvec2 position, double heading, double speed, const WaterSurface& water,
             double time);
  /// One step of dt seconds (1/120 is meant; 1/30 still holds) from the sea's `time`.
  void step(const WaterSurface& water, const WindField& wind, double time, double dt);

  // ---- the helm, as a player uses it -----------------------------------------------------------
  BoatControls& controls() { return controls_; }
  const BoatControls& controls() const { return controls_; }
  /// Rudder -1 to 1; any but 0 ends heading hold and manoeuvres.
  void steer(double rudder);
  /// Moves a sheet by `delta` (fractions, + out) from where it is, and ends automatic trim.
  void trim_main(double delta);
  void trim_jib(double delta);
  void hold_heading(bool on);
  bool holding() const { return helmsman_.task() != Helmsman::Task::kNone; }
  bool recovering() const { return helmsman_.recovering(); }
  void hold_heading_at(double heading) { helmsman_.hold(heading); }
  /// Through the wind by herself, then holds the new heading until the helm is touched.
  void tack_or_gybe();
  double hold_target() const { return helmsman_.target(); }  ///< rad
  Helmsman::Task manoeuvre() const { return helmsman_.task(); }

  // ---- what she tells --------------------------------------------------------------------------
  const BoatState& state() const { return state_; }
  const Navigation& navigation() const { return navigation_; }
  const BoatForces& forces() const { return forces_; }
  const R8Parameters& parameters() const { return p_; }
  /// Of the centre of mass, in the boat frame.
  const glm::dvec3& centre_of_mass() const { return centre_; }
  const Hull& hull() const { return hull_; }
  /// How often a limit had to step in since start(): 0 in honest work.
  long limit_hits() const { return limits_ + probe_.limits() - probe_limits_at_start_; }
  /// Added mass included, J.
  double kinetic_energy() const { return body_.kinetic_energy(motion_); }

  /// An extra force (N, boat axes) at a place in the boat frame, applied every step: a tow, a test.
  void set_external_force(glm::dvec3 force, glm::dvec3 place);
  /// Moves her as a rigid whole, at rest: for tests of stability and decay.
  void displace(glm::dvec3 shift, double heel, double pitch);

 private:
  void actuate(double dt);
  void add_gravity(Loads& loads) const;
  void add_underwater(Loads& loads, double dt);
  void add_air(Loads& loads, const WindField& wind, double dt);
  void navigate();
  HelmView helm_view() const;
  /// Widest angles of boom and jib, rad, for a sheet of 0 to 1.
  double main_limit(double sheet) const;
  double jib_limit(double sheet) const;
  glm::dvec3 point_velocity(const glm::dvec3& place) const;

  R8Parameters p_;
  Hull hull_;
  Foil keel_, rudder_;
  Rig rig_;
  RigidBody body_;
  glm::dvec3 centre_{0.0};

  BoatControls controls_;
  BoatState state_;
  RigidBodyState motion_;
  WaterProbe probe_;
  HullMemory memory_;
  DeckWater deck_water_;
  Boom boom_;
  AutoTrim autotrim_;
  Helmsman helmsman_;
  RigReading rig_reading_;
  Navigation navigation_;
  BoatForces forces_;
  glm::dvec3 external_force_{0.0}, external_place_{0.0};
  glm::dvec2 true_wind_{0.0};
  glm::dvec3 masthead_wind_{0.0};
  bool set_sail_ = false;  ///< sheets and reefs were set after start()
  double jib_aback_ = 0.0, flow_angle_ = 0.0, flow_speed_ = 0.0, felt_heel_ = 0.0,
         free_rudder_ = 0.0;
  long limits_ = 0, probe_limits_at_start_ = 0;
};

}  // namespace offing
