#include "engine/boat/rig.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

#include "engine/boat/curve.h"
#include "engine/boat/hydrostatics.h"
#include "engine/core/angles.h"

namespace offing {
namespace {

// ORC VPP documentation 2023, 5.1: mainsail and jib, against apparent wind angle in degrees.
const Curve& main_lift() {
  static const Curve kCurve({{0, 0.0},
                             {7, 0.862},
                             {9, 1.052},
                             {12, 1.164},
                             {28, 1.347},
                             {60, 1.353},
                             {90, 1.267},
                             {120, 0.931},
                             {150, 0.388},
                             {180, -0.112}});
  return kCurve;
}
const Curve& main_drag() {
  static const Curve kCurve({{0, 0.043},
                             {7, 0.026},
                             {9, 0.023},
                             {12, 0.023},
                             {28, 0.033},
                             {60, 0.113},
                             {90, 0.383},
                             {120, 0.969},
                             {150, 1.316},
                             {180, 1.345}});
  return kCurve;
}
const Curve& jib_lift() {
  static const Curve kCurve({{7, 0.0},
                             {15, 1.0},
                             {20, 1.375},
                             {27, 1.45},
                             {50, 1.45},
                             {60, 1.25},
                             {100, 0.40},
                             {150, 0.0},
                             {180, -0.10}});
  return kCurve;
}
const Curve& jib_drag() {
  static const Curve kCurve({{7, 0.05},
                             {15, 0.032},
                             {20, 0.031},
                             {27, 0.037},
                             {50, 0.25},
                             {60, 0.35},
                             {100, 0.73},
                             {150, 0.95},
                             {180, 0.90}});
  return kCurve;
}
/// Effective over real height of the rig: the jib seals the slot close-hauled.
double effective_height(double apparent_deg) {
  static const Curve kCurve({{15, 1.2}, {23, 1.2}, {40, 1.0}, {75, 0.8}});
  return 0.92 * kCurve(apparent_deg);
}

constexpr double kBestAttack = 22.0;  // degrees
constexpr double kPlate = 1.4;        // normal force of a stalled sail

/// The wind's turning moment on a boom at `boom`, per q A arm: the side the sail is pressed to.
/// From ahead the boom streams; by the lee it stays on its stop until the wind has come some 25
/// degrees round the stern, because a sail's twist lets the head go first.
double boom_press(double attack, double boom) {
  constexpr double kTwist = 0.47;  // 1/rad
  const double side = boom < 0.0 ? -1.0 : 1.0;
  const double a = wrap_tau(side * attack);
  const double over = kPi - kTwist * boom * boom;  // attack at which it comes over
  return side * (a < over ? std::sin(kPi * a / over) : -std::sin(kPi * (a - over) / (kTau - over)));
}

}  // namespace

SailReading sail_coefficients(bool jib, double angle, double sheeted, double stop, double flat) {
  SailReading reading;
  const double attack = wrap_pi(angle - sheeted);
  const double side = attack < 0.0 ? -1.0 : 1.0;
  const double a = degrees(std::abs(attack));
  const double apparent = degrees(std::abs(angle));
  // Held on its stop the sail keeps the table, until the wind comes round its leech.
  const double on_stop = smooth_step(stop - radians(10.0), stop - radians(1.0), std::abs(sheeted)) *
                         (1.0 - smooth_step(120.0, 160.0, a));

  double efficiency = std::sin(0.5 * kPi * std::min(a / kBestAttack, 1.0));
  const double past = smooth_step(kBestAttack, 55.0, a) * (1.0 - on_stop);
  efficiency *= 1.0 - 0.45 * past;
  double lift = (jib ? jib_lift() : main_lift())(apparent)*efficiency;
  if (apparent > 90.0) {
    // By the lee the table's lift would point the wrong way: it fades through dead aft.
    lift *= std::clamp(side * std::sin(angle) / std::sin(radians(10.0)), 0.0, 1.0);
  }
  lift *= flat;
  double drag = (jib ? jib_drag() : main_drag())(apparent);

  // Held to windward of the boat's middle it is aback: no table was measured there, and cloth
  // pressed against its own belly is a plate from the first.
  const double aback = smooth_step(0.0, 8.0, a - apparent);
  const double plate = std::max(smooth_step(35.0, 75.0, a) * (1.0 - on_stop), aback);
  const double sine = std::sin(std::abs(attack)), cosine = std::cos(attack);
  lift += (kPlate * sine * cosine - lift) * plate;
  drag += (kPlate * sine * sine + 0.04 - drag) * plate;
  // A stalled sail drags like the plate it is turning into, well before it is one.
  drag += (1.0 - plate) * past * 0.25;

  reading.luff = 1.0 - smooth_step(3.0, 12.0, a);
  drag += 0.06 * reading.luff;  // flogging
  const double profile = jib ? 0.016 : 0.0138;
  reading.attack = attack;
  reading.lift = side * lift;
  reading.drag = drag + profile * lift * lift;
  reading.stall = past;
  reading.fill =
      side * std::clamp(std::hypot(lift, drag - 0.1) / 1.3, 0.0, 1.0) * (1.0 - reading.luff);
  return reading;
}

glm::dvec3 Rig::main_centre(const SailSet& set) const {
  const double size = set.reef, lowered = size * (1.0 - 0.406 * (1.0 - set.flat));
  return {size * p_.main_chord * std::sin(set.main_angle), p_.main_height * lowered,
          p_.mast_z + size * p_.main_chord * std::cos(set.main_angle)};
}

glm::dvec3 Rig::jib_centre(const SailSet& set) const {
  const double size = set.reef, lowered = size * (1.0 - 0.406 * (1.0 - set.flat));
  return {size * p_.jib_chord * std::sin(set.jib_angle), p_.jib_height * lowered,
          p_.jib_tack_z + size * p_.jib_chord * std::cos(set.jib_angle)};
}

RigReading Rig::add_loads(Loads& loads, const SailSet& set, const glm::dvec3& centre,
                          const glm::dvec3& main_wind, const glm::dvec3& jib_wind) const {
  RigReading reading;
  const glm::dvec2 main_flow(main_wind.x, main_wind.z), jib_flow(jib_wind.x, jib_wind.z);
  const double main_speed = glm::length(main_flow), jib_speed = glm::length(jib_flow);
  if (!set.hoisted || p_.main_area + p_.jib_area <= 0.0 || main_speed < 1e-6 || jib_speed < 1e-6)
    return reading;
  const double main_from = std::atan2(main_flow.x, main_flow.y);
  const double jib_from = std::atan2(jib_flow.x, jib_flow.y);
  reading.main = sail_coefficients(false, main_from, set.main_angle, p_.boom_stop, set.flat);
  reading.jib = sail_coefficients(true, jib_from, set.jib_angle, p_.jib_stop, set.flat);

  const double size = set.reef * set.reef;
  const double main_area = p_.main_area * size, jib_area = p_.jib_area * size;
  const double area = main_area + jib_area;
  const double lift = (reading.main.lift * main_area + reading.jib.lift * jib_area) / area;
  const double height = effective_height(degrees(std::abs(main_from))) * p_.mast_top * set.reef;
  const double induced = lift * lift * area / (kPi * height * height);

  const auto push = [&](const SailReading& sail, glm::dvec2 flow, double speed, double sail_area,
                        const glm::dvec3& at) {
    const glm::dvec2 along = flow / speed, across(along.y, -along.x);
    const glm::dvec2 force = 0.5 * kAirDensity * speed * speed * sail_area *
                             (sail.lift * across + (sail.drag + induced) * along);
    loads.add({force.x, 0.0, force.y}, at - centre);
  };
  push(reading.main, main_flow, main_speed, main_area, main_centre(set));
  push(reading.jib, jib_flow, jib_speed, jib_area, jib_centre(set));

  constexpr double kBoomArm = 0.9;  // m: mast to the pressure's centre on a swinging sail
  reading.boom_torque = 0.5 * kAirDensity * main_speed * main_speed * main_area * kBoomArm *
                        set.reef * boom_press(reading.main.attack, set.main_angle);
  return reading;
}

}  // namespace offing
