#include "engine/clouds/cloud_map.h"
#include "engine/core/error.h"
#include "engine/core/paths.h"
#include "engine/graph/gl_device.h"
#include "engine/io/image.h"
#include "engine/platform/headless_context.h"
#include "engine/sky/sky_panorama.h"
#include "game/export/exports.h"
#include "game/frame/frame_view.h"
#include "game/frame/quality.h"
#include "game/world/clouds.h"

namespace offing {

namespace {

// Finer than the probe's: the picture has more pixels.
constexpr CloudMapSettings kCloudMap = {.size = 256, .slices = 1, .steps = 96, .light_steps = 4};

}  // namespace

// The sky with its clouds above the scene's place and time, as seen from where its free camera
// stands, or from the boat.
void export_sky(const Scene& scene, const Options& options) {
  check_image_name(options.out);
  const glm::ivec2 size = options.size.value_or(glm::ivec2(1024, 512));
  constexpr double kAboardEye = 3.0;  // m
  const bool free = scene.camera.mode == static_cast<int>(CameraMode::kFree);
  const double height = free ? scene.camera.position.y : kAboardEye;

  const HeadlessContext context;
  ShaderLibrary shaders(data_root() / "shaders");
  GlDevice device;
  FrameGraph graph(device);
  Sky sky(shaders, quality_named(options.quality, false).level);
  const std::vector<Star> stars = load_stars(star_file());
  SkyLightModel model(Starlight(stars, load_milky_way(milky_way_file())));
  const Environment& environment = scene.environment;
  const SkyLight& light = model.update(environment.celestial(), environment.haze, height);
  CloudField field(shaders);
  CloudShadow shadow(shaders);
  CloudMap map(shaders, kCloudMap);
  const CloudView clouds = cloud_view(scene, environment, {0.0, height, 0.0});
  const auto add_clouds = [&](FrameGraph& frame, const SkyIds& sky_ids) {
    shared::CloudData data = cloud_data(clouds, light);
    shadow.plan(clouds, data);
    const CloudIds ids = field.add(frame, clouds, data);
    const CloudShadowIds shadow_ids = shadow.add(frame, field, ids, clouds);
    return map.add(frame, field, ids, sky, sky_ids, shadow, shadow_ids, clouds, light, data);
  };
  Panorama panorama =
      sky_panorama(shaders, graph, sky, light, environment.wind.speed, size.x, size.y, add_clouds);
  if (!options.no_discs) {
    add_discs(panorama, light);
    add_stars(panorama, light, stars);
  }
  Image image{size.x, size.y, 3, {}, {}};
  image.pixels.reserve(panorama.pixels.size() * 3);
  for (const glm::dvec3& pixel : panorama.pixels) {
    for (int c = 0; c < 3; ++c) image.pixels.push_back(static_cast<float>(pixel[c]));
  }
  const CelestialState& celestial = environment.celestial();
  const glm::dvec3 level = panorama.level_illuminance();
  write_image(options.out, image, {"R", "G", "B"},
              {{"sun_elevation_deg", celestial.sun.elevation_deg},
               {"sun_azimuth_deg", celestial.sun.azimuth_deg},
               {"moon_elevation_deg", celestial.moon.elevation_deg},
               {"moon_azimuth_deg", celestial.moon.azimuth_deg},
               {"camera_height_m", height},
               {"level_illuminance_lux", 0.2126 * level.x + 0.7152 * level.y + 0.0722 * level.z}});
}

}  // namespace offing
