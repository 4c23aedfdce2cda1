#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "engine/core/paths.h"
#include "engine/gl/debug.h"
#include "engine/io/file.h"
#include "engine/platform/headless_context.h"
#include "game/bench/bench_report.h"
#include "game/bench/benches.h"
#include "game/bench/sea_transforms.h"

namespace offing {
namespace {

nlohmann::ordered_json json_of(const Taken& taken) {
  return {{"median_ms", taken.median}, {"least_ms", taken.least}, {"cpu_ms", taken.processor}};
}

}  // namespace

// Transforms side by side; maps by size, cascades and storage, time against error.
void bench_ocean(const Options& options) {
  const HeadlessContext context;
  gl::require_opengl_45();
  ShaderLibrary shaders(data_root() / "shaders");
  const int repeats = std::max(options.frames / 4, 3);
  nlohmann::ordered_json json;
  json["renderer"] = gl::current_renderer().name;
  json["software"] = gl::current_renderer().software;
  for (const int size : {64, 128, 256, 512}) {
    const auto runs = time_transforms(shaders, size, 3, repeats);
    for (const TransformRun& run : runs) {
      nlohmann::ordered_json row = {
          {"transform", run.name}, {"size", size}, {"complex_fields", 12}};
      row.update(json_of(run.taken));
      row["gflops"] = run.gflops;
      row["snr_db"] = run.snr_db;
      json["transforms"].push_back(row);
    }
  }
  deliver_report(options, json.dump(2) + "\n");
}

}  // namespace offing
