#include "game/export/sea_run.h"

#include "engine/core/paths.h"
#include "game/frame/quality.h"

namespace offing {

OceanSettings sea_settings(const Options& options) {
  OceanSettings settings = OceanSettings::of_quality(quality_named(options.quality, false).level);
  settings.query_cascades = settings.cascades;
  return settings;
}

SeaRun::SeaRun(const Scene& scene, const Options& options)
    : shaders_(data_root() / "shaders"),
      graph_(device_),
      ocean_(shaders_, sea_settings(options)),
      time_(scene.environment.elapsed()) {
  ocean_.set_sea(scene.sea, scene.environment, static_cast<std::uint64_t>(scene.seed));
  ocean_.prime(graph_, time_);
}

}  // namespace offing
