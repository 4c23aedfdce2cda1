#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/io/file.h"
#include "engine/io/image.h"
#include "game/export/exports.h"
#include "game/export/sea_run.h"

namespace offing {
namespace {

// dx, dy, dz, slope_x, slope_z and the Jacobian of one cascade.
Image cascade_maps(const std::vector<float>& displacement, const std::vector<float>& slopes,
                   int size, std::size_t cascade) {
  const std::size_t points = static_cast<std::size_t>(size) * size;
  Image image{size, size, 6, std::vector<float>(points * 6)};
  for (std::size_t i = 0; i < points; ++i) {
    const float* d = &displacement[(cascade * points + i) * 4];
    const float* s = &slopes[(cascade * points + i) * 4];
    float* out = &image.pixels[i * 6];
    for (std::size_t c = 0; c < 3; ++c) out[c] = d[c];
    out[3] = s[0];
    out[4] = s[1];
    out[5] = (1.0f + s[2]) * (1.0f + s[3]) - d[3] * d[3];
  }
  return image;
}

double variance_of(const Image& image, std::size_t channel) {
  double sum = 0.0, squares = 0.0;
  const std::size_t channels = static_cast<std::size_t>(image.channels);
  const std::size_t count = image.pixels.size() / channels;
  for (std::size_t i = 0; i < count; ++i) {
    const double value = static_cast<double>(image.pixels[i * channels + channel]);
    sum += value;
    squares += value * value;
  }
  const double mean = sum / static_cast<double>(count);
  return squares / static_cast<double>(count) - mean * mean;
}

}  // namespace

void export_ocean(const Scene& scene, const Options& options) {
  std::filesystem::path stem = options.out;
  if (stem.extension() == ".json" || stem.extension() == ".exr") stem.replace_extension();
  const SeaRun run(scene, options);
  const Ocean& ocean = run.ocean();
  const int size = ocean.settings().size;
  const std::vector<float> displacement = ocean.maps().displacement().read_floats(4);
  const std::vector<float> slopes = ocean.maps().slopes().read_floats(4);
  const double time = scene.environment.elapsed();

  nlohmann::ordered_json json;
  const SeaStatistics& sea = ocean.statistics();
  json["time_s"] = time;
  json["spectrum"] = {{"m0", sea.m0},
                      {"hs_m", sea.hs},
                      {"tp_s", sea.tp},
                      {"mean_square_slope", sea.mean_square_slope}};
  for (std::size_t c = 0; c < ocean.cascades().size(); ++c) {
    const CascadeBand& band = ocean.cascades()[c].band;
    const Image maps = cascade_maps(displacement, slopes, size, c);
    const std::string name = fmt::format("{}-c{}.exr", stem.string(), c);
    write_image(name, maps, {"dx", "dy", "dz", "slope_x", "slope_z", "jacobian"},
                {{"length_m", band.length},
                 {"angle_rad", band.angle},
                 {"k_min", band.k_min},
                 {"k_max", band.k_max},
                 {"time_s", time}});
    json["cascades"].push_back({{"file", std::filesystem::path(name).filename().string()},
                                {"N", size},
                                {"length_m", band.length},
                                {"angle_rad", band.angle},
                                {"k_min", band.k_min},
                                {"k_max", band.k_max},
                                {"variance", variance_of(maps, 1)},
                                {"variance_expected", ocean.cascades()[c].variance},
                                {"slope_variance", variance_of(maps, 3) + variance_of(maps, 4)}});
  }
  write_text(stem.string() + ".json", json.dump(2) + "\n");
}

}  // namespace offing
