#include "game/world/scene.h"

#include <fmt/core.h>

#include "engine/core/error.h"
#include "engine/core/paths.h"
#include "engine/io/scene_file.h"

namespace offing {

FieldTable Scene::fields() {
  FieldTable table;
  environment.describe(table);
  sea.describe(table);
  table.group("clouds").choice("method", cloud_method, {"volumetric", "ellipsoids"},
                               "how low clouds are drawn: in volume, or as Gardner's ellipsoids");
  gardner.describe(table);
  sky.describe(table);
  clouds.describe(table);
  exposure.describe(table);
  table.group("boat")
      .number("heading", boat.heading_deg, {-360.0, 360.0}, "deg",
              "where the bow points at the start, true")
      .number("speed", boat.speed, {0.0, 10.0}, "m/s", "speed through the water at the start")
      .vector("position", boat.position, {-1e7, 1e7}, "m", "x (east), z (south) at the start")
      .text("file", boat.file, "a name in assets/boats/, or a TOML file", nullptr)
      .text("model", boat.model, "a glTF file to draw her by; none: R8's own", nullptr);
  table.group("camera")
      .choice("mode", camera.mode, {"chase", "helm", "mast", "free", "orbit"},
              "where one looks from")
      .vector("position", camera.position, {-1e7, 1e7}, "m", "of the free camera: x, y (up), z")
      .vector("target", camera.target, {-1e7, 1e7}, "m",
              "what the free camera looks at: x, y (up), z")
      .number("fov", camera.field_of_view_deg, {1.0, 120.0}, "deg", "vertical field of view");
  table.group("");
  table.flag("flotsam", flotsam, "barrel, crate and raft float ahead of the start");
  table.integer("seed", seed, {0, 1000000000}, "of the sea's waves");
  table.group("sea").number("time", sea_time, {-1e9, 1e9}, "s", "the sea's clock at the start");
  return table;
}

Scene make_scene(const std::string& name_or_file, const std::vector<std::string>& settings) {
  Scene scene;
  const FieldTable table = scene.fields();
  load_scene(find_scene(name_or_file), table);
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) {
      throw InputError(
          fmt::format("--set {}: must be key=value; --list-keys names the keys", setting));
    }
    table.set_from_text(setting.substr(0, equals), setting.substr(equals + 1), "--set");
  }
  scene.boat.parameters =
      load_boat(find_data("boat.file", "boat", scene.boat.file, data_root() / "assets" / "boats"));
  scene.environment.apply_fields();
  scene.environment.set_elapsed(scene.sea_time);
  return scene;
}

}  // namespace offing
