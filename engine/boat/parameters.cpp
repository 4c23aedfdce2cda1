#include "engine/boat/parameters.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "engine/boat/hydrostatics.h"
#include "engine/core/error.h"
#include "engine/io/scene_file.h"

namespace offing {
namespace {

void describe_rig(FieldTable& table, RigParameters& r) {
  table.group("rig")
      .number("mast_top", r.mast_top, {0.0, 60.0}, "m", "of the mast above the waterline; 0: none")
      .number("mast_z", r.mast_z, {-25.0, 25.0}, "m", "of the mast, aft of amidships")
      .number("main_area", r.main_area, {0.0, 500.0}, "m^2", "of the mainsail")
      .number("jib_area", r.jib_area, {0.0, 500.0}, "m^2", "of the jib")
      .number("main_height", r.main_height, {0.0, 40.0}, "m", "of the mainsail's effort")
      .number("jib_height", r.jib_height, {0.0, 40.0}, "m", "of the jib's effort")
      .number("main_chord", r.main_chord, {0.0, 15.0}, "m", "from mast to the main's effort")
      .number("jib_chord", r.jib_chord, {0.0, 15.0}, "m", "from tack to the jib's effort")
      .number("jib_tack_z", r.jib_tack_z, {-30.0, 30.0}, "m", "of the jib's tack")
      .number("boom_inertia", r.boom_inertia, {0.5, 1e4}, "kg m^2", "of the boom about the mast")
      .number("boom_damping", r.boom_damping, {0.0, 50.0}, "1/s", "of the boom's swing")
      .number("boom_moment", r.boom_moment, {0.0, 1e4}, "kg m", "of the boom's weight")
      .number("boom_least", r.boom_least, {0.0, 0.7}, "rad", "angle of the boom sheeted in")
      .number("boom_stop", r.boom_stop, {0.8, 1.57}, "rad", "angle of the boom on the shrouds")
      .number("jib_least", r.jib_least, {0.0, 0.7}, "rad", "angle of the jib sheeted in")
      .number("jib_stop", r.jib_stop, {0.8, 1.57}, "rad", "widest angle of the jib");
}

void describe_hull(FieldTable& table, R8Parameters& p) {
  table.group("lines")
      .number("length_overall", p.lines.length_overall, {1.0, 60.0}, "m", "length of the hull")
      .number("length_waterline", p.lines.length_waterline, {1.0, 50.0}, "m", "on the waterline")
      .number("beam", p.lines.beam, {0.2, 15.0}, "m", "on deck")
      .number("beam_waterline", p.lines.beam_waterline, {0.2, 15.0}, "m", "on the waterline")
      .number("freeboard", p.lines.freeboard, {0.1, 10.0}, "m", "amidships")
      .number("midship_area", p.lines.midship_area, {0.01, 100.0}, "m^2", "under water amidships")
      .number("canoe_volume", p.lines.canoe_volume, {0.05, 500.0}, "m^3", "under water, no keel");
  HullDamping& d = p.damping;
  table.group("damping")
      .number("heave_per_area", d.heave_per_area, {0.0, 1e5}, "N s/m^3", "by the waves she makes")
      .number("heave_drag", d.heave_drag, {0.0, 5.0}, "", "drag coefficient up and down")
      .number("impact", d.impact, {0.0, 2.0}, "", "share of a half-disc's added mass in a slam")
      .number("cross_flow", d.cross_flow, {0.0, 5.0}, "", "drag coefficient sideways")
      .number("munk", d.munk, {0.0, 1.0}, "", "share of Munk's moment")
      .number("roll", d.roll, {0.0, 1e6}, "N m s", "against rolling")
      .number("yaw", d.yaw, {0.0, 1e6}, "N m s", "against yawing");
  DeckPlan& k = p.deck;
  table.group("deck")
      .number("rail", k.rail, {0.0, 2.0}, "m", "height of the toe rail")
      .number("scuppers", k.scuppers, {0.05, 600.0}, "s", "that water takes to run off the deck")
      .number("deck_height", k.deck_height, {0.0, 10.0}, "m", "of the deck's middle")
      .number("deck_area", k.deck_area, {0.0, 500.0}, "m^2", "of deck")
      .number("cockpit_from", k.cockpit_from, {-30.0, 30.0}, "m", "forward end of the cockpit")
      .number("cockpit_to", k.cockpit_to, {-30.0, 30.0}, "m", "after end of the cockpit")
      .number("cockpit_breadth", k.cockpit_breadth, {0.05, 15.0}, "m", "of the cockpit")
      .number("cockpit_floor", k.cockpit_floor, {-5.0, 10.0}, "m", "height of its floor")
      .number("cockpit_depth", k.cockpit_depth, {0.05, 5.0}, "m", "to its rim")
      .number("coaming", k.coaming, {0.0, 2.0}, "m", "of its rim over the deck's edge")
      .number("drain_area", k.drain_area, {0.0, 1.0}, "m^2", "of its drains");
}

}  // namespace

void describe(FieldTable& table, R8Parameters& p) {
  constexpr FieldTable::Range kPlace{-30.0, 30.0};
  table.group("")
      .number("mass", p.mass, {10.0, 1e6}, "kg", "crew included")
      .vector("centre_of_gravity", p.centre_of_gravity, kPlace, "m", "crew amidships")
      .vector("gyration", p.gyration, {0.05, 20.0}, "m", "radii in pitch, yaw, roll")
      .vector("added_mass", p.added_mass, {0.0, 5.0}, "", "of the mass: sway, heave, surge")
      .vector("added_inertia", p.added_inertia, {0.0, 5.0}, "", "in pitch, yaw, roll");
  describe_hull(table, p);
  table.group("keel")
      .number("span", p.keel_span, {0.05, 10.0}, "m", "depth of the keel")
      .number("chord", p.keel_chord, {0.05, 10.0}, "m", "length of the keel")
      .number("area", p.keel_area, {0.001, 50.0}, "m^2", "seen from the side")
      .number("volume", p.keel_volume, {0.0, 50.0}, "m^3", "of the keel")
      .vector("place", p.keel_place, kPlace, "m", "of its lift");
  table.group("rudder")
      .number("span", p.rudder_span, {0.05, 10.0}, "m", "depth of the rudder")
      .number("chord", p.rudder_chord, {0.05, 10.0}, "m", "length of the rudder")
      .number("area", p.rudder_area, {0.001, 50.0}, "m^2", "seen from the side")
      .vector("place", p.rudder_place, kPlace, "m", "of its lift")
      .number("most", p.rudder_most, {0.05, 1.2}, "rad", "hard over")
      .number("rate", p.rudder_rate, {0.05, 10.0}, "rad/s", "how fast it is turned");
  describe_rig(table, p.rig);
  table.group("windage")
      .vector("area", p.windage, {0.0, 500.0}, "m^2", "drag area across, up, along")
      .number("height", p.windage_height, {-5.0, 40.0}, "m", "where it pushes");
  table.group("crew")
      .number("mass", p.crew_mass, {0.0, 1e5}, "kg", "part of the mass")
      .number("reach", p.crew_reach, {0.0, 10.0}, "m", "out to windward")
      .number("speed", p.crew_speed, {0.0, 5.0}, "m/s", "from side to side");
  table.group("motor")
      .number("power", p.motor_power, {0.0, 1e6}, "W", "of the motor")
      .number("efficiency", p.motor_efficiency, {0.0, 1.0}, "", "of the propeller")
      .number("thrust", p.motor_thrust, {0.0, 1e6}, "N", "at most");
}

std::optional<Impossibility> impossibility(const R8Parameters& p) {
  const auto wrong = [](std::string key, double value, std::string why) {
    return Impossibility{key, fmt::format("{} = {}: {}", key, value, why)};
  };
  const HullLines& l = p.lines;
  const RigParameters& r = p.rig;
  if (l.length_overall < l.length_waterline + 0.1) {
    return wrong("lines.length_overall", l.length_overall,
                 fmt::format("must be 0.1 m more than length_waterline = {}", l.length_waterline));
  }
  if (l.beam < l.beam_waterline) {
    return wrong("lines.beam", l.beam,
                 fmt::format("must be at least beam_waterline = {}", l.beam_waterline));
  }
  const HullShape hull = keelboat(l);
  const double most = kWaterDensity * (immerse_level(hull, 20.0).volume + p.keel_volume);
  if (p.mass > 0.95 * most) {
    return wrong("mass", p.mass, fmt::format("she would sink: her hull carries {:.0f} kg", most));
  }
  const double lowest = p.keel_place.y - p.keel_span, highest = l.freeboard + 0.3;
  const glm::dvec3& c = p.centre_of_gravity;
  if (std::abs(c.x) > 0.5 * l.beam || c.y < lowest || c.y > highest ||
      std::abs(c.z) > 0.5 * l.length_overall) {
    return Impossibility{
        "centre_of_gravity",
        fmt::format("centre_of_gravity = {},{},{}: outside the boat, which reaches {} m to each "
                    "side, {:.2f} to {:.2f} m up and {} m fore and aft",
                    c.x, c.y, c.z, 0.5 * l.beam, lowest, highest, 0.5 * l.length_overall)};
  }
  const double needed =
      std::max(r.main_area > 0.0 ? r.main_height : 0.0, r.jib_area > 0.0 ? r.jib_height : 0.0);
  if (r.main_area + r.jib_area > 0.0 && r.mast_top <= std::max(needed, l.freeboard)) {
    return wrong("rig.mast_top", r.mast_top,
                 fmt::format("no mast for the sails, whose effort is {} m up", needed));
  }
  if (p.crew_mass > 0.9 * p.mass) {
    return wrong("crew.mass", p.crew_mass, fmt::format("must be at most 0.9 of mass = {}", p.mass));
  }
  if (p.crew_reach > 0.5 * l.beam) {
    return wrong("crew.reach", p.crew_reach, fmt::format("beyond the side at {} m", 0.5 * l.beam));
  }
  if (p.deck.cockpit_to < p.deck.cockpit_from) {
    return wrong("deck.cockpit_to", p.deck.cockpit_to,
                 fmt::format("forward of cockpit_from = {}", p.deck.cockpit_from));
  }
  return std::nullopt;
}

void check(const R8Parameters& parameters) {
  R8Parameters copy = parameters;
  FieldTable table;
  describe(table, copy);
  for (const Field& field : table.fields()) {
    table.set_from_text(field.key, FieldTable::to_text(field), "boat");
  }
  if (const auto wrong = impossibility(parameters)) throw InputError("boat: " + wrong->why);
}

R8Parameters load_boat(const std::filesystem::path& file) {
  R8Parameters parameters;
  FieldTable table;
  describe(table, parameters);
  const FieldPlaces places = load_fields(file, table);
  if (const auto wrong = impossibility(parameters)) {
    const auto place = places.find(wrong->key);
    throw InputError(
        fmt::format("{}: {}", place == places.end() ? file.string() : place->second, wrong->why));
  }
  return parameters;
}

}  // namespace offing
