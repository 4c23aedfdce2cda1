#include "game/export/export.h"

#include <fmt/core.h>

#include <map>

#include "engine/core/error.h"
#include "game/export/exports.h"

namespace offing {

void run_export(const Options& options) {
  static const std::map<std::string, void (*)(const Scene&, const Options&)> exports = {
      {"boat", export_boat},       {"clouds", export_clouds}, {"ephemeris", export_ephemeris},
      {"heights", export_heights}, {"ocean", export_ocean},   {"polar", export_polar},
      {"sky", export_sky},
  };
  const auto found = exports.find(options.what);
  if (found == exports.end()) {
    std::string names;
    for (const auto& [name, function] : exports) names += (names.empty() ? "" : ", ") + name;
    throw InputError(fmt::format("export {}: no such data; there are {}", options.what, names));
  }
  Scene scene = make_scene(options.scene, options.sets);
  if (options.seed) scene.seed = *options.seed;
  if (options.time) scene.environment.set_elapsed(*options.time);
  found->second(scene, options);
}

}  // namespace offing
