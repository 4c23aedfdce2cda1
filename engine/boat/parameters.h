#pragma once
#include <glm/vec3.hpp>

#include <filesystem>
#include <optional>
#include <string>

#include "engine/boat/deck_water.h"
#include "engine/boat/hull.h"
#include "engine/boat/hull_shape.h"
#include "engine/boat/rig.h"
#include "engine/core/fields.h"

namespace offing {

/// The numbers of R8, an 8 m keelboat. SI units; places in the boat frame (x to starboard, y up,
/// z aft, origin amidships on the design waterline).
struct R8Parameters {
  double mass = 1950.0;  ///< kg, crew included
  /// Crew amidships. Gives 1.05 m of metacentric height, and level trim on the designed lines.
  glm::dvec3 centre_of_gravity{0.0, -0.00505, 0.0257};
  glm::dvec3 gyration{2.0, 2.1, 1.05};       ///< m: pitch, yaw, roll
  glm::dvec3 added_mass{1.0, 1.0, 0.05};     ///< of the mass: sway, heave, surge
  glm::dvec3 added_inertia{0.9, 0.7, 0.15};  ///< of the inertia: pitch, yaw, roll
  HullLines lines;
  HullDamping damping;
  DeckPlan deck;

  double keel_span = 1.16, keel_chord = 0.73, keel_area = 0.85;
  double keel_volume = 0.062;               ///< m^3
  glm::dvec3 keel_place{0.0, -0.80, -0.4};  ///< of its lift
  double rudder_span = 0.95, rudder_chord = 0.42, rudder_area = 0.40;
  glm::dvec3 rudder_place{0.0, -0.60, 3.0};
  double rudder_most = 0.6109;  ///< rad, 35 degrees
  double rudder_rate = 0.4538;  ///< rad/s, 26 degrees/s

  RigParameters rig;
  glm::dvec3 windage{6.1, 0.0, 2.3};  ///< m^2 of drag area across and along
  double windage_height = 1.8;        ///< m, where it pushes

  double crew_mass = 250.0;   ///< kg, part of `mass`
  double crew_reach = 1.125;  ///< m, out to windward
  double crew_speed = 0.8;    ///< m/s

  double motor_power = 8000.0;  ///< W
  double motor_efficiency = 0.5;
  double motor_thrust = 1100.0;  ///< N at most
};

/// Adds the parameters to a table, bound to this object: key, range, unit and help of each.
void describe(FieldTable& table, R8Parameters& parameters);

/// Numbers that each may be fine but not together: the key of one of them, and what is wrong.
struct Impossibility {
  std::string key, why;
};
std::optional<Impossibility> impossibility(const R8Parameters& parameters);

/// Throws InputError that names the first number no boat can have.
void check(const R8Parameters& parameters);

/// The parameters of a TOML file; what it leaves out is R8's. Throws InputError
/// "file:line: key = value: …" for the first number that no boat can have.
R8Parameters load_boat(const std::filesystem::path& file);

}  // namespace offing
