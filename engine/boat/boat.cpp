#include "engine/boat/boat.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

#include "engine/boat/hydrostatics.h"
#include "engine/boat/resistance.h"
#include "engine/core/angles.h"

namespace offing {
namespace {

const glm::dvec3 kStarboard(1.0, 0.0, 0.0), kAft(0.0, 0.0, 1.0);

double clean(double value, double low, double high) {
  return std::isfinite(value) ? std::clamp(value, low, high) : 0.0;
}

double approach(double value, double target, double most) {
  return value + std::clamp(target - value, -most, most);
}

bool finite(const RigidBodyState& s) {
  const double sum = s.position.x + s.position.y + s.position.z + s.velocity.x + s.velocity.y +
                     s.velocity.z + s.angular_velocity.x + s.angular_velocity.y +
                     s.angular_velocity.z + s.orientation.w + s.orientation.x + s.orientation.y +
                     s.orientation.z;
  return std::isfinite(sum);
}

/// Turns about y: a heading h looks along (sin h, 0, -cos h).
glm::dquat facing(double heading) { return glm::angleAxis(-heading, glm::dvec3(0.0, 1.0, 0.0)); }

double heading_of(const glm::dquat& orientation) {
  const glm::dvec3 ahead = orientation * glm::dvec3(0.0, 0.0, -1.0);
  return wrap_tau(std::atan2(ahead.x, -ahead.z));
}

double heel_of(const glm::dquat& orientation) {
  const glm::dvec3 right = orientation * kStarboard, mast = orientation * glm::dvec3(0, 1, 0);
  return std::atan2(-right.y, mast.y);
}

double pitch_of(const glm::dquat& orientation) {
  const glm::dvec3 ahead = orientation * glm::dvec3(0.0, 0.0, -1.0);
  return std::asin(std::clamp(ahead.y, -1.0, 1.0));
}

/// How much of a foil is under water, by the depth of its middle and its span.
double wet_part(double depth, double span) { return std::clamp(0.5 + depth / span, 0.0, 1.0); }

constexpr double kReefSizes[] = {1.0, 0.87, 0.74, 0.6};

}  // namespace

BoatState interpolate(const BoatState& a, const BoatState& b, double t) {
  BoatState s = t < 0.5 ? a : b;
  const auto mix = [t](auto from, auto to) { return from + (to - from) * t; };
  s.position = mix(a.position, b.position);
  s.orientation = glm::slerp(a.orientation, b.orientation, t);
  s.velocity = mix(a.velocity, b.velocity);
  s.angular_velocity = mix(a.angular_velocity, b.angular_velocity);
  s.boom_angle = mix(a.boom_angle, b.boom_angle);
  s.jib_angle = mix(a.jib_angle, b.jib_angle);
  s.rudder_angle = mix(a.rudder_angle, b.rudder_angle);
  s.crew_offset = mix(a.crew_offset, b.crew_offset);
  s.main_fill = mix(a.main_fill, b.main_fill);
  s.jib_fill = mix(a.jib_fill, b.jib_fill);
  s.main_luff = mix(a.main_luff, b.main_luff);
  s.jib_luff = mix(a.jib_luff, b.jib_luff);
  s.main_stall = mix(a.main_stall, b.main_stall);
  s.jib_stall = mix(a.jib_stall, b.jib_stall);
  s.apparent_wind = mix(a.apparent_wind, b.apparent_wind);
  return s;
}

Boat::Boat(const R8Parameters& parameters)
    : p_((check(parameters), parameters)),
      hull_(keelboat(p_.lines), p_.damping),
      keel_(p_.keel_span, p_.keel_chord, p_.keel_area),
      rudder_(p_.rudder_span, p_.rudder_chord, p_.rudder_area),
      rig_(p_.rig) {
  centre_ = p_.centre_of_gravity;
  body_.mass = p_.mass;
  body_.added_mass = p_.mass * p_.added_mass;
  body_.inertia = p_.mass * p_.gyration * p_.gyration;
  body_.added_inertia = body_.inertia * p_.added_inertia;
}

void Boat::start(glm::dvec2 position, double heading, double speed, const WaterSurface& water,
                 double time) {
  state_ = BoatState{};
  motion_ = RigidBodyState{};
  boom_ = Boom{};
  autotrim_.reset();
  helmsman_.release();
  probe_.reset();
  memory_.reset();
  deck_water_.reset();
  rig_reading_ = RigReading{};
  forces_ = BoatForces{};
  navigation_ = Navigation{};
  jib_aback_ = flow_angle_ = flow_speed_ = felt_heel_ = free_rudder_ = 0.0;
  set_sail_ = false;
  true_wind_ = glm::dvec2(0.0);
  masthead_wind_ = glm::dvec3(0.0);
  limits_ = 0;
  probe_limits_at_start_ = probe_.limits();

  motion_.orientation = facing(heading);
  motion_.position = glm::dvec3(position.x, 0.0, position.y) + motion_.orientation * centre_;
  // Newton's method on heave, pitch and roll with the stiffness of the design waterline.
  const Immersion design = immerse_level(hull_.shape(), 0.0);
  const double weight = p_.mass * kGravity, unit = kWaterDensity * kGravity;
  const double metacentre = design.centroid.y + design.transverse_inertia / design.volume;
  const double stiffness = weight * std::max(metacentre - centre_.y, 0.2);
  for (int i = 0; i < 40; ++i) {
    const glm::dvec3 origin = motion_.position - motion_.orientation * centre_;
    probe_.sample(hull_.shape(), origin, motion_.orientation, water, time, 1.0);
    probe_.reset();
    motion_.velocity = probe_.mean_velocity();
    Loads loads;
    add_gravity(loads);
    add_underwater(loads, 1.0);
    memory_.reset();
    const glm::dvec3 force = motion_.orientation * loads.force();
    // Far from the surface the linear step would jump over it.
    const double rise = i == 0 ? probe_.at(hull_.shape(), 0.0).height - origin.y
                               : std::clamp(force.y / (unit * design.waterplane), -0.3, 0.3);
    motion_.position.y += 0.8 * rise + (i == 0 ? 0.2 * rise : 0.0);
    const glm::dvec3 torque = loads.torque();
    const double pitch = torque.x / (unit * design.longitudinal_inertia);
    const double roll = torque.z / stiffness;
    const glm::dquat turn = glm::angleAxis(std::clamp(0.7 * pitch, -0.1, 0.1), kStarboard) *
                            glm::angleAxis(std::clamp(0.7 * roll, -0.1, 0.1), kAft);
    const glm::dvec3 foot = motion_.position - motion_.orientation * centre_;
    motion_.orientation = glm::normalize(motion_.orientation * turn);
    motion_.position = foot + motion_.orientation * centre_;
  }
  const glm::dvec3 origin = motion_.position - motion_.orientation * centre_;
  probe_.sample(hull_.shape(), origin, motion_.orientation, water, time, 1.0);
  const glm::dvec3 ahead = motion_.orientation * glm::dvec3(0.0, 0.0, -1.0);
  motion_.velocity = speed * ahead + probe_.mean_velocity();
  forces_ = BoatForces{};
  state_.position = origin;
  state_.orientation = motion_.orientation;
  state_.velocity = motion_.velocity;
  state_.mainsheet = controls_.mainsheet;
  state_.jib_sheet = controls_.jib_sheet;
  navigate();
}

void Boat::steer(double rudder) {
  controls_.rudder = clean(rudder, -1.0, 1.0);
  if (controls_.rudder != 0.0) helmsman_.release();
}

void Boat::trim_main(double delta) {
  controls_.auto_trim = false;
  controls_.mainsheet = clean(state_.mainsheet + delta, 0.0, 1.0);
  controls_.jib_sheet = state_.jib_sheet;
}

void Boat::trim_jib(double delta) {
  controls_.auto_trim = false;
  controls_.mainsheet = state_.mainsheet;
  controls_.jib_sheet = clean(state_.jib_sheet + delta, 0.0, 1.0);
}

void Boat::hold_heading(bool on) {
  if (on) {
    helmsman_.hold(navigation_.heading);
  } else {
    helmsman_.release();
  }
}

void Boat::tack_or_gybe() { helmsman_.tack_or_gybe(helm_view()); }

HelmView Boat::helm_view() const {
  return {navigation_.heading, navigation_.turn_rate, navigation_.stw, navigation_.leeway,
          navigation_.twd,     free_rudder_,          p_.rudder_most};
}

void Boat::set_external_force(glm::dvec3 force, glm::dvec3 place) {
  external_force_ = force;
  external_place_ = place;
}

void Boat::displace(glm::dvec3 shift, double heel, double pitch) {
  const glm::dvec3 foot = motion_.position - motion_.orientation * centre_ + shift;
  motion_.orientation = glm::normalize(motion_.orientation * glm::angleAxis(pitch, kStarboard) *
                                       glm::angleAxis(-heel, kAft));
  motion_.position = foot + motion_.orientation * centre_;
  motion_.velocity = motion_.angular_velocity = glm::dvec3(0.0);
  motion_.acceleration = motion_.angular_acceleration = glm::dvec3(0.0);
  state_.position = foot;
  state_.orientation = motion_.orientation;
  navigate();
}

glm::dvec3 Boat::point_velocity(const glm::dvec3& place) const {
  return motion_.velocity +
         motion_.orientation * glm::cross(motion_.angular_velocity, place - centre_);
}

double Boat::main_limit(double sheet) const {
  return p_.rig.boom_least + sheet * (p_.rig.boom_stop - p_.rig.boom_least);
}

double Boat::jib_limit(double sheet) const {
  return p_.rig.jib_least + sheet * (p_.rig.jib_stop - p_.rig.jib_least);
}

void Boat::actuate(double dt) {
  // Player and helmsman say where the bow is to go: astern the rudder works the other way.
  const bool astern = navigation_.stw < -0.1;
  const bool by_hand = helmsman_.task() == Helmsman::Task::kNone;
  const double wish =
      by_hand ? clean(controls_.rudder, -1.0, 1.0) : helmsman_.step(helm_view(), dt);
  const double helm = astern ? -wish : wish;
  state_.rudder_angle = approach(state_.rudder_angle, helm * p_.rudder_most, p_.rudder_rate * dt);

  const double reef_most = kReefSizes[std::clamp(controls_.reef, 0, 3)];
  TrimOrder order;
  order.main_sheet = main_limit(clean(controls_.mainsheet, 0.0, 1.0));
  order.jib_sheet = jib_limit(clean(controls_.jib_sheet, 0.0, 1.0));
  order.reef = reef_most;
  if (controls_.auto_trim && flow_speed_ > 0.0) {
    order = autotrim_.step(
        p_.rig,
        {flow_angle_, flow_speed_, navigation_.leeway, navigation_.heel, navigation_.stw, wish},
        reef_most, dt);
  }
  // Sheets are pulled slower than they run out; a reef takes its time.
  constexpr double kPull = 0.35, kRun = 1.0, kCut = 0.3, kReefing = 0.08;  // 1/s
  const auto sheet = [&](double& now, double wanted) {
    now = approach(now, wanted, (wanted > now ? kRun : kPull) * dt);
  };
  const RigParameters& rig = p_.rig;
  if (!set_sail_ && flow_speed_ > 0.0) {  // she starts with sails set for the wind she meets
    state_.flat = order.flat;
    state_.reef = order.reef;
    set_sail_ = true;
  }
  sheet(state_.mainsheet, (order.main_sheet - rig.boom_least) / (rig.boom_stop - rig.boom_least));
  sheet(state_.jib_sheet, (order.jib_sheet - rig.jib_least) / (rig.jib_stop - rig.jib_least));
  if (controls_.auto_trim) {  // whoever takes over the sheets finds them as they are
    controls_.mainsheet = state_.mainsheet;
    controls_.jib_sheet = state_.jib_sheet;
  }
  state_.flat = approach(state_.flat, order.flat, kCut * dt);
  state_.reef = approach(state_.reef, order.reef, kReefing * dt);
  jib_aback_ = order.jib_aback;

  constexpr double kFeel = 6.0, kAllOut = radians(3.0), kClinging = radians(60.0);
  // Slower than she rolls: a crew that chases every roll makes it worse.
  felt_heel_ += (navigation_.heel - felt_heel_) * (dt / (dt + kFeel));
  double seat = 0.0;
  if (controls_.crew_hikes && std::abs(navigation_.heel) < kClinging) {
    seat = -p_.crew_reach * std::clamp(felt_heel_ / kAllOut, -1.0, 1.0);
  }
  state_.crew_offset = approach(state_.crew_offset, seat, p_.crew_speed * dt);
}

void Boat::add_gravity(Loads& loads) const {
  const glm::dvec3 down = glm::conjugate(motion_.orientation) * glm::dvec3(0.0, -kGravity, 0.0);
  loads.add(p_.mass * down, glm::dvec3(0.0));
  loads.add_torque(glm::cross(glm::dvec3(state_.crew_offset, 0.0, 0.0), p_.crew_mass * down));
}

void Boat::add_underwater(Loads& loads, double dt) {
  const glm::dquat body_from_world = glm::conjugate(motion_.orientation);
  const HullReading reading = hull_.add_loads(loads, body_, motion_, centre_, probe_, memory_, dt);
  forces_.volume = reading.volume;
  forces_.slam = reading.slam;
  forces_.buoyancy = body_from_world * reading.buoyancy;

  const glm::dvec3 origin = motion_.position - motion_.orientation * centre_;
  const auto depth = [&](const glm::dvec3& place) {
    return probe_.at(hull_.shape(), place.z).above(origin + motion_.orientation * place);
  };
  const auto flow = [&](const glm::dvec3& place, const glm::dvec3& water) {
    return body_from_world * (water - point_velocity(place));
  };

  const double keel_wet = wet_part(depth(p_.keel_place), p_.keel_span);
  const glm::dvec3 keel_lift(0.0, kWaterDensity * kGravity * p_.keel_volume * keel_wet, 0.0);
  loads.add(body_from_world * keel_lift, p_.keel_place - centre_);
  forces_.volume += p_.keel_volume * keel_wet;
  forces_.buoyancy += body_from_world * keel_lift;

  // The keel is deep and long: it feels the mean of the water along the hull. The rudder feels the
  // water under the stern.
  const glm::dvec3 keel_flow =
      flow(p_.keel_place, probe_.left_at(-p_.keel_place.y) * probe_.mean_velocity());
  const glm::dvec2 keel = keel_wet * keel_.force({keel_flow.x, keel_flow.z}, 0.0);
  forces_.keel = {keel.x, 0.0, keel.y};
  loads.add(forces_.keel, p_.keel_place - centre_);

  const glm::dvec3 undisturbed =
      flow(p_.rudder_place, probe_.left_at(-p_.rudder_place.y) *
                                probe_.at(hull_.shape(), p_.rudder_place.z).velocity);
  const double downwash = keel_wet * keel_.downwash(std::atan2(keel_flow.x, keel_flow.z));
  const glm::dvec3 rudder_flow = glm::angleAxis(-downwash, glm::dvec3(0.0, 1.0, 0.0)) * undisturbed;
  free_rudder_ = std::atan2(rudder_flow.x, rudder_flow.z);
  const double rudder_wet = wet_part(depth(p_.rudder_place), p_.rudder_span);
  const glm::dvec2 rudder =
      rudder_wet * rudder_.force({rudder_flow.x, rudder_flow.z}, state_.rudder_angle);
  forces_.rudder = {rudder.x, 0.0, rudder.y};
  loads.add(forces_.rudder, p_.rudder_place - centre_);

  // Resistance along the boat, at the middle of the canoe body; stern first she drags a third more.
  const glm::dvec3 place(0.0, -0.12, centre_.z);
  const double astern = -flow(place, probe_.mean_velocity()).z;
  const double speed = std::abs(astern);
  const double sunk = std::clamp(reading.volume / p_.lines.canoe_volume, 0.0, 2.0);
  const double resistance =
      sunk * (upright_resistance(speed) + heeled_resistance(speed, heel_of(motion_.orientation))) *
      (astern > 0.0 ? 1.3 : 1.0);
  forces_.resistance = resistance;
  loads.add_damping(kAft, place - centre_, resistance / std::max(speed, 1e-3), astern);

  const double throttle = clean(controls_.motor, -1.0, 1.0);
  if (throttle != 0.0) {
    const double push =
        std::min(p_.motor_thrust, p_.motor_efficiency * p_.motor_power / std::max(speed, 0.1));
    const glm::dvec3 propeller(0.0, -0.45, 2.5);
    loads.add({0.0, 0.0, -throttle * push * wet_part(depth(propeller), 0.4)}, propeller - centre_);
  }
}

void Boat::add_air(Loads& loads, const WindField& wind, double dt) {
  const glm::dquat body_from_world = glm::conjugate(motion_.orientation);
  const glm::dvec3 origin = motion_.position - motion_.orientation * centre_;
  const auto air = [&](const glm::dvec3& place) {
    const glm::dvec3 at = origin + motion_.orientation * place;
    glm::dvec2 w = wind.velocity({at.x, at.z}, std::max(at.y - probe_.mean_height(), 0.05));
    if (!std::isfinite(w.x) || !std::isfinite(w.y)) {
      w = glm::dvec2(0.0);
      ++limits_;
    }
    constexpr double kMostWind = 90.0;
    return glm::clamp(w, -kMostWind, kMostWind);
  };
  const auto apparent = [&](const glm::dvec3& place) {
    const glm::dvec2 w = air(place);
    return body_from_world * (glm::dvec3(w.x, 0.0, w.y) - point_velocity(place));
  };

  const SailSet set{boom_.angle, state_.jib_angle, state_.flat, state_.reef, controls_.sails_up};
  const glm::dvec3 main_wind = apparent(rig_.main_centre(set));
  const glm::dvec3 jib_wind = apparent(rig_.jib_centre(set));
  const glm::dvec3 before = loads.force();
  rig_reading_ = rig_.add_loads(loads, set, centre_, main_wind, jib_wind);
  forces_.sails = loads.force() - before;
  flow_angle_ = std::atan2(main_wind.x, main_wind.z);
  flow_speed_ = std::hypot(main_wind.x, main_wind.z);

  // Hull and mast: areas across and along her, at the speed of the wind in the jib.
  const double pressure = 0.5 * kAirDensity * std::hypot(jib_wind.x, jib_wind.z);
  forces_.windage = pressure * p_.windage * jib_wind;
  loads.add(forces_.windage, glm::dvec3(0.0, p_.windage_height, -0.3) - centre_);

  // The boom hangs: heeled, it wants to the low side.
  const double low_side = (body_from_world * glm::dvec3(0.0, -kGravity, 0.0)).x;
  const double hang = p_.rig.boom_moment * low_side * std::cos(boom_.angle);
  // Dead before the wind with the sheet eased, the crew pushes it out.
  constexpr double kPush = 30.0, kShort = radians(20.0);
  const bool push = controls_.auto_trim && std::abs(boom_.angle) < kShort &&
                    state_.mainsheet > 0.5 && std::abs(flow_angle_) > radians(150.0);
  const double crew = push ? (boom_.angle < 0.0 ? -kPush : kPush) : 0.0;
  boom_.step(rig_reading_.boom_torque + hang + crew, p_.rig.boom_inertia, p_.rig.boom_damping,
             main_limit(state_.mainsheet), dt);

  // The jib is cloth: it goes where the wind blows it, as far as its sheet.
  const double jib_flow = std::atan2(jib_wind.x, jib_wind.z);
  // Nearly dead aft it stays on the side where it is.
  const double jib_sheet = jib_limit(state_.jib_sheet);
  constexpr double kHeldAback = radians(25.0), kJibRate = 3.0, kByTheLee = radians(155.0);
  double jib_goes = std::clamp(jib_flow, -jib_sheet, jib_sheet);
  if (std::abs(jib_flow) > kByTheLee && std::abs(state_.jib_angle) > 0.1) {
    jib_goes = std::copysign(jib_sheet, state_.jib_angle);
  }
  if (jib_aback_ != 0.0) jib_goes = jib_aback_ * kHeldAback;
  state_.jib_angle = approach(state_.jib_angle, jib_goes, kJibRate * dt);

  const glm::dvec3 masthead(0.0, 10.0, p_.rig.mast_z);
  masthead_wind_ = apparent(masthead);
  const glm::dvec3 top = origin + motion_.orientation * masthead;
  true_wind_ = wind.velocity({top.x, top.z}, 10.0);
  if (!std::isfinite(true_wind_.x) || !std::isfinite(true_wind_.y)) true_wind_ = glm::dvec2(0.0);

  state_.boom_angle = boom_.angle;
  state_.boom_rate = boom_.rate;
  state_.main_fill = rig_reading_.main.fill;
  state_.jib_fill = rig_reading_.jib.fill;
  state_.main_stall = rig_reading_.main.stall;
  state_.jib_stall = rig_reading_.jib.stall;
  state_.main_luff = rig_reading_.main.luff;
  state_.jib_luff = rig_reading_.jib.luff;
  state_.apparent_wind = main_wind;
}

void Boat::step(const WaterSurface& water, const WindField& wind, double time, double dt) {
  if (!(dt > 0.0)) return;
  const RigidBodyState last = motion_;
  actuate(dt);
  motion_ = RigidBody::middle(last, dt);
  const glm::dvec3 origin = motion_.position - motion_.orientation * centre_;
  probe_.sample(hull_.shape(), origin, motion_.orientation, water, time + 0.5 * dt, dt);

  Loads loads;
  add_gravity(loads);
  add_underwater(loads, dt);
  deck_water_.step(p_.deck, hull_.shape(), probe_, origin, motion_.orientation, dt);
  deck_water_.add_weight(loads, p_.deck, motion_.orientation, centre_);
  add_air(loads, wind, dt);
  if (external_force_ != glm::dvec3(0.0)) loads.add(external_force_, external_place_ - centre_);
  motion_ = last;
  limits_ += body_.step(motion_, loads, dt);
  if (!finite(motion_)) {
    motion_ = last;
    motion_.velocity = motion_.angular_velocity = glm::dvec3(0.0);
    motion_.acceleration = motion_.angular_acceleration = glm::dvec3(0.0);
    ++limits_;
  }

  state_.position = motion_.position - motion_.orientation * centre_;
  state_.orientation = motion_.orientation;
  state_.velocity = motion_.velocity;
  state_.angular_velocity = motion_.angular_velocity;
  state_.deck_water = deck_water_.on_deck();
  state_.cockpit_water = deck_water_.in_cockpit();
  navigate();
  navigation_.water_is_late = water.stale(time + dt);
}

void Boat::navigate() {
  Navigation& n = navigation_;
  const double heading = heading_of(motion_.orientation);
  const glm::dvec3 ahead(std::sin(heading), 0.0, -std::cos(heading));
  const glm::dvec3 right(std::cos(heading), 0.0, std::sin(heading));
  const glm::dvec3& v = motion_.velocity;
  n.heading = heading;
  n.sog = std::hypot(v.x, v.z);
  n.cog = n.sog > 0.05 ? wrap_tau(std::atan2(v.x, -v.z)) : heading;
  const glm::dvec3 through = v - probe_.mean_velocity();
  n.stw = glm::dot(through, ahead);
  const double drift = glm::dot(through, right);
  n.leeway = std::hypot(n.stw, drift) > 0.1 ? std::atan2(drift, std::abs(n.stw)) : 0.0;
  n.heel = heel_of(motion_.orientation);
  n.pitch = pitch_of(motion_.orientation);
  n.turn_rate = -(motion_.orientation * motion_.angular_velocity).y;

  n.tws = std::hypot(true_wind_.x, true_wind_.y);
  n.twd = n.tws > 0.0 ? wrap_tau(std::atan2(-true_wind_.x, true_wind_.y)) : 0.0;
  n.twa = wrap_pi(n.twd - heading);
  n.aws = std::hypot(masthead_wind_.x, masthead_wind_.z);
  // Flow that blows to starboard comes from port.
  n.awa = std::atan2(-masthead_wind_.x, masthead_wind_.z);
  n.vmg = n.tws > 0.0 ? -(v.x * true_wind_.x + v.z * true_wind_.y) / n.tws : 0.0;
  n.point = point_of_sail(n.twa);

  const SailReading& main = rig_reading_.main;
  const SailReading& jib = rig_reading_.jib;
  const double lee = -n.awa;  // positive: pressed to starboard
  const bool aback = lee * main.fill < -0.2 * std::abs(lee) &&
                     lee * jib.fill < -0.2 * std::abs(lee) && std::abs(n.awa) < radians(120.0);
  if (std::abs(n.heel) > radians(75.0)) {
    n.trouble = Trouble::kCapsized;
  } else if (!controls_.sails_up) {
    n.trouble = controls_.motor == 0.0 ? Trouble::kSailsDown : Trouble::kNone;
  } else if (n.tws < 0.8) {
    n.trouble = Trouble::kNoWind;
  } else if (n.stw < -0.2) {
    n.trouble = Trouble::kGoingAstern;
  } else if (std::abs(n.twa) < radians(32.0) && n.stw < 0.8) {
    n.trouble = Trouble::kInIrons;
  } else if (aback) {
    n.trouble = Trouble::kAback;
  } else if (main.luff > 0.5 && jib.luff > 0.5) {
    n.trouble = Trouble::kLuffing;
  } else if (main.stall > 0.5) {
    n.trouble = Trouble::kStalled;
  } else if (std::abs(n.heel) > radians(35.0)) {
    n.trouble = Trouble::kOverpowered;
  } else {
    n.trouble = Trouble::kNone;
  }
}

}  // namespace offing
