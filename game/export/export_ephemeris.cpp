#include <nlohmann/json.hpp>

#include "engine/io/file.h"
#include "game/export/exports.h"

namespace offing {

void export_ephemeris(const Scene& scene, const Options& options) {
  const CelestialState& sky = scene.environment.celestial();
  const auto body = [](const SkyPosition& position) -> nlohmann::ordered_json {
    return {{"azimuth_deg", position.azimuth_deg},
            {"elevation_deg", position.elevation_deg},
            {"elevation_airless_deg", position.elevation_airless_deg}};
  };
  nlohmann::ordered_json json;
  json["sun"] = body(sky.sun);
  json["moon"] = body(sky.moon);
  json["moon"]["lit_fraction"] = sky.moon_lit_fraction;
  json["sidereal_time_h"] = sky.sidereal_time_h;
  write_text(options.out, json.dump(2) + "\n");
}

}  // namespace offing
