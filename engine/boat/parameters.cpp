#include "engine/boat/parameters.h"

#include <fmt/core.h>

#include "engine/core/error.h"

namespace offing {
namespace {

void require(const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return;
  throw InputError(fmt::format("boat.{} = {}: must be {} to {}", name, value, low, high));
}

}  // namespace

void check(const R8Parameters& p) {
  require("mass", p.mass, 100.0, 1e5);
  require("metacentric_height", p.metacentric_height, 0.1, 5.0);
  for (int i = 0; i < 3; ++i) {
    require("gyration", p.gyration[i], 0.1, 20.0);
    require("added_mass", p.added_mass[i], 0.0, 5.0);
    require("added_inertia", p.added_inertia[i], 0.0, 5.0);
  }
  require("lines.length_waterline", p.lines.length_waterline, 1.0, 50.0);
  require("lines.length_overall", p.lines.length_overall, p.lines.length_waterline + 0.1, 60.0);
  require("lines.beam_waterline", p.lines.beam_waterline, 0.2, 15.0);
  require("lines.beam", p.lines.beam, p.lines.beam_waterline, 15.0);
  require("lines.freeboard", p.lines.freeboard, 0.1, 10.0);
  require("lines.canoe_volume", p.lines.canoe_volume, 0.05, 100.0);
  require("keel_area", p.keel_area, 0.01, 20.0);
  require("keel_volume", p.keel_volume, 0.0, 10.0);
  require("rudder_area", p.rudder_area, 0.01, 10.0);
  require("rudder_most", p.rudder_most, 0.05, 1.2);
  require("rudder_rate", p.rudder_rate, 0.05, 10.0);
  require("rig.mast_top", p.rig.mast_top, p.rig.main_height, 60.0);
  require("rig.main_area", p.rig.main_area, 0.1, 500.0);
  require("rig.jib_area", p.rig.jib_area, 0.1, 500.0);
  require("rig.boom_inertia", p.rig.boom_inertia, 0.5, 1e4);
  require("crew_mass", p.crew_mass, 0.0, 0.9 * p.mass);
  require("crew_reach", p.crew_reach, 0.0, 0.5 * p.lines.beam);
}

}  // namespace offing
