#include <fmt/core.h>

#include <cmath>

#include "engine/boat/boat.h"
#include "engine/boat/environment_wind.h"
#include "engine/boat/polar.h"
#include "engine/core/angles.h"
#include "engine/core/error.h"
#include "engine/io/file.h"
#include "engine/ocean/direct_water.h"
#include "game/export/exports.h"
#include "game/world/sea.h"

namespace offing {

void export_polar(const Scene& scene, const Options& options) {
  std::string text = "tws_kn,twa_deg,speed_kn,heel_deg,leeway_deg\n";
  const std::vector<double> speeds = parse_numbers("--tws", options.tws);
  const std::vector<double> angles = parse_numbers("--twa", options.twa);
  for (const double tws : speeds) {
    if (tws < 0.0 || tws > 60.0) throw InputError(fmt::format("--tws {}: must be 0 to 60 kn", tws));
  }
  for (const double twa : angles) {
    if (twa < -180.0 || twa > 180.0)
      throw InputError(fmt::format("--twa {}: must be -180 to 180 deg", twa));
  }
  for (const double tws : speeds) {
    for (const double twa : angles) {
      const SteadySailing sailing =
          sail_steadily(scene.boat.parameters, metres_per_second(tws), radians(twa));
      text += fmt::format("{},{},{:.4f},{:.3f},{:.3f}\n", tws, twa, knots(sailing.speed),
                          degrees(sailing.heel), degrees(sailing.leeway));
    }
  }
  write_text(options.out, text);
}

void export_boat(const Scene& start, const Options& options) {
  Scene scene = start;
  const DirectWater water = direct_water(scene);
  const EnvironmentWind wind(scene.environment);
  Boat boat(scene.boat.parameters);
  boat.start(scene.boat.position, radians(scene.boat.heading_deg), scene.boat.speed, water,
             scene.environment.elapsed());
  std::string text =
      "time_s,x,y,z,heading_deg,heel_deg,pitch_deg,vx,vy,vz,speed_kn,boom_deg,jib_deg,rudder_deg,"
      "buoyancy_x,buoyancy_y,buoyancy_z,sails_x,sails_y,sails_z,keel_x,keel_y,keel_z,"
      "rudder_x,rudder_y,rudder_z,resistance\n";
  const auto steps = static_cast<long>(std::llround(options.seconds / options.dt));
  for (long step = 0; step <= steps; ++step) {
    const BoatState& s = boat.state();
    const Navigation& n = boat.navigation();
    const BoatForces& f = boat.forces();
    text += fmt::format(
        "{:.6f},{:.5f},{:.5f},{:.5f},{:.4f},{:.4f},{:.4f},{:.5f},{:.5f},{:.5f},{:.4f},{:.3f},{:.3f}"
        ",{:.3f}",
        static_cast<double>(step) * options.dt, s.position.x, s.position.y, s.position.z,
        degrees(wrap_tau(n.heading)), degrees(n.heel), degrees(n.pitch), s.velocity.x, s.velocity.y,
        s.velocity.z, knots(n.stw), degrees(s.boom_angle), degrees(s.jib_angle),
        degrees(s.rudder_angle));
    for (const glm::dvec3& force : {f.buoyancy, f.sails, f.keel, f.rudder}) {
      text += fmt::format(",{:.2f},{:.2f},{:.2f}", force.x, force.y, force.z);
    }
    text += fmt::format(",{:.2f}\n", f.resistance);
    if (step == steps) break;
    boat.step(water, wind, scene.environment.elapsed(), options.dt);
    scene.environment.advance(options.dt);
  }
  write_text(options.out, text);
}

}  // namespace offing
