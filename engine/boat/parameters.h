#pragma once
#include <glm/vec3.hpp>

#include "engine/boat/deck_water.h"
#include "engine/boat/hull.h"
#include "engine/boat/hull_shape.h"
#include "engine/boat/rig.h"

namespace offing {

/// The numbers of R8, an 8 m keelboat. SI units; places in the boat frame (x to starboard, y up,
/// z aft, origin amidships on the design waterline).
struct R8Parameters {
  double mass = 1950.0;              ///< kg, crew included
  double metacentric_height = 1.05;  ///< m, upright, crew amidships: places the centre of gravity
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

/// Throws InputError that names the first number no boat can have.
void check(const R8Parameters& parameters);

}  // namespace offing
