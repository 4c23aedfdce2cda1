#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "engine/io/file.h"
#include "engine/io/image.h"
#include "game/export/exports.h"
#include "game/export/sea_run.h"

namespace offing {
namespace {

Image picture_of(const CascadeExport& cascade) {
  Image image{cascade.size, cascade.size, 6, {}, {}};
  for (std::size_t i = 0; i < cascade.dy.size(); ++i) {
    for (const auto* field : {&cascade.dx, &cascade.dy, &cascade.dz, &cascade.slope_x,
                              &cascade.slope_z, &cascade.jacobian}) {
      image.pixels.push_back((*field)[i]);
    }
  }
  return image;
}

}  // namespace

void export_ocean(const Scene& scene, const Options& options) {
  std::filesystem::path stem = options.out;
  if (stem.extension() == ".json" || stem.extension() == ".exr") stem.replace_extension();
  SeaRun run(scene, options);
  const double time = scene.environment.elapsed();
  const SeaStatistics& sea = run.ocean().statistics();
  nlohmann::ordered_json json;
  json["time_s"] = time;
  json["spectrum"] = {{"m0", sea.m0},
                      {"hs_m", sea.hs},
                      {"tp_s", sea.tp},
                      {"mean_square_slope", sea.mean_square_slope}};
  for (const CascadeExport& cascade : run.maps()) {
    const std::size_t number = json["cascades"].size();
    const CascadeBand& band = cascade.band;
    const std::string name = fmt::format("{}-c{}.exr", stem.string(), number);
    write_image(name, picture_of(cascade), {"dx", "dy", "dz", "slope_x", "slope_z", "jacobian"},
                {{"length_m", band.length},
                 {"angle_rad", band.angle},
                 {"k_min", band.k_min},
                 {"k_max", band.k_max},
                 {"time_s", time}});
    json["cascades"].push_back({{"file", std::filesystem::path(name).filename().string()},
                                {"N", cascade.size},
                                {"length_m", band.length},
                                {"angle_rad", band.angle},
                                {"k_min", band.k_min},
                                {"k_max", band.k_max},
                                {"variance", cascade.variance},
                                {"variance_expected", run.ocean().cascades()[number].variance},
                                {"slope_variance", cascade.slope_variance}});
  }
  write_text(stem.string() + ".json", json.dump(2) + "\n");
}

}  // namespace offing
