#include <fmt/core.h>

#include "engine/core/error.h"
#include "engine/io/file.h"
#include "game/export/csv.h"
#include "game/export/exports.h"
#include "game/export/sea_run.h"
#include "game/world/sea.h"

namespace offing {

void export_heights(const Scene& scene, const Options& options) {
  const std::vector<glm::dvec2> points = read_points(options.points);
  std::vector<WaterSample> samples(points.size());
  const double time = scene.environment.elapsed();
  if (options.method == "direct") {
    const OceanSettings settings = sea_settings(options);
    direct_water(scene, settings.cascades, settings.size).sample(points, time, samples);
  } else if (options.method.empty() || options.method == "readback") {
    Scene by_gpu = scene;
    by_gpu.sea.queries = kReadbackQueries;
    SeaRun(by_gpu, options).water().sample(points, time, samples);
  } else {
    throw InputError(fmt::format("--method {}: heights has readback and direct", options.method));
  }
  std::string text = "x,z,height,nx,ny,nz,velocity_y\n";
  for (std::size_t i = 0; i < points.size(); ++i) {
    const WaterSample& s = samples[i];
    text += fmt::format("{},{},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}\n", points[i].x, points[i].y,
                        s.height, s.normal.x, s.normal.y, s.normal.z, s.velocity.y);
  }
  write_text(options.out, text);
}

}  // namespace offing
