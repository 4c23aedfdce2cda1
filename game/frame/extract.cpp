#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>

#include <algorithm>
#include <cmath>

#include "engine/clouds/cloud_field.h"
#include "engine/clouds/lightning.h"
#include "engine/core/angles.h"
#include "engine/sky/sky.h"
#include "game/frame/frame_view.h"
#include "game/world/clouds.h"

namespace offing {
namespace {

constexpr double kNear = 0.15;  // m

BoatView boat_view(const World& world, glm::dvec3 camera, const SkyLight& light) {
  const BoatState& state = world.drawn_boat();
  BoatView view;
  view.position = glm::vec3(state.position - camera);
  view.orientation = glm::quat(state.orientation);
  const RigParameters& rig = world.boat().parameters().rig;
  const auto real = [](double value) { return static_cast<float>(value); };
  view.main = {real(state.boom_angle), real(state.main_fill), real(state.main_luff),
               real(state.main_stall),
               real(rig.boom_least + state.mainsheet * (rig.boom_stop - rig.boom_least))};
  view.jib = {real(state.jib_angle), real(state.jib_fill), real(state.jib_luff),
              real(state.jib_stall),
              real(rig.jib_least + state.jib_sheet * (rig.jib_stop - rig.jib_least))};
  view.rudder = static_cast<float>(state.rudder_angle);
  view.reef = static_cast<float>(state.reef);
  view.hoisted = world.boat().controls().sails_up;
  view.apparent_wind = glm::vec3(state.apparent_wind);
  view.under_power = world.boat().controls().motor != 0.0;
  // Lamps are lit when the light fails: from about sunset on, in full when 10 lx are left.
  const double lux = std::max(light.level_illuminance(), 1e-6);
  view.navigation_lights =
      static_cast<float>(std::clamp(std::log(400.0 / lux) / std::log(40.0), 0.0, 1.0));
  return view;
}

/// The clouds that are drawn as Gardner did, which the volumetric ones then leave out.
GardnerView gardner_view(const World& world, CloudView& clouds, bool sky_visible) {
  constexpr double kMiddle = 4100.0, kHigh = 8200.0;  // m
  const Scene& scene = world.scene();
  GardnerView view;
  view.weather = clouds.weather;
  view.base = clouds.parameters.base;
  view.low_carried = cloud_carried(clouds, view.base);
  view.middle_carried = cloud_carried(clouds, kMiddle);
  view.high_carried = cloud_carried(clouds, kHigh);
  view.wind_to = clouds.wind_to;
  view.eye = clouds.eye;
  view.ellipsoids = scene.cloud_method == static_cast<int>(CloudMethod::kEllipsoids);
  view.sky_visible = sky_visible;
  view.seed = clouds.seed;
  view.parameters = scene.gardner;
  clouds.weather.high = clouds.weather.middle = 0.0;
  if (view.ellipsoids) clouds.weather.cover = 0.0;
  return view;
}

UnderwaterView underwater_view(const World& world, const CameraPose& pose, const SkyLight& light) {
  UnderwaterView view;
  view.eye = pose.position;
  view.forward = pose.orientation * glm::dvec3(0.0, 0.0, -1.0);
  view.sun_direction = light.sun_direction;
  view.sun_illuminance = light.sun_illuminance;
  view.moon_direction = light.moon_direction;
  view.moon_illuminance = light.moon_illuminance;
  view.sky_illuminance = light.sky_illuminance;
  view.clarity = world.scene().sea.clarity_m;
  view.boat_visible = glm::distance(world.drawn_boat().position, pose.position) < 150.0;
  return view;
}

// Whether any pixel looks below the horizon of the sea, waves included.
bool sea_in_view(const glm::mat4& relative_from_clip, double camera_height) {
  constexpr double kEarthRadius = 6.36e6, kTallestWave = 20.0;
  const double height = std::max(camera_height, 0.0);
  const double dip = std::sqrt(2.0 * height / kEarthRadius) - std::atan2(kTallestWave, 4000.0);
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      const glm::vec4 point = relative_from_clip * glm::vec4(x, y, 1.0f, 1.0f);
      const glm::dvec3 way = glm::normalize(glm::dvec3(glm::vec3(point)));
      if (way.y < -std::sin(dip)) return true;
    }
  }
  // Straight down counts even where every corner looks up.
  const glm::vec4 down = glm::inverse(relative_from_clip) * glm::vec4(0.0f, -1.0f, 0.0f, 1.0f);
  return down.w > 0.0f && std::abs(down.x) <= down.w && std::abs(down.y) <= down.w;
}

}  // namespace

Extractor::Extractor()
    : light_(Starlight(load_stars(star_file()), load_milky_way(milky_way_file()))) {}

SkyLight Extractor::paint(const Scene& scene, SkyLight light) {
  const SkyLook& look = scene.sky;
  const auto mode = static_cast<PaletteMode>(look.mode);
  if (mode == PaletteMode::kOff) return light;
  if (palette_name_ != look.palette) {
    palette_ = load_palette(find_palette(look.palette));
    palette_name_ = look.palette;
  }
  const Environment& environment = scene.environment;
  const double hour = solar_hour(environment.utc_seconds(), environment.longitude_deg);
  apply_palette(light, palette_.at(hour), mode, look.strength);
  return light;
}

FrameView Extractor::extract(const World& world, glm::ivec2 size, double dt, int number) {
  const Environment& environment = world.environment();
  const CameraPose& pose = world.camera().pose();
  FrameView view;
  view.size = size;
  view.camera = pose.position;
  view.sea_time = world.drawn_time();
  view.gust_origin = environment.gust_origin();
  view.squalls = environment.squalls();
  view.squall_corner = environment.squall_corner();
  view.probe = world.scene().sky.probe;
  view.chlorophyll = chlorophyll_of(world.scene().sea.clarity_m);
  view.light =
      paint(world.scene(),
            light_.update(environment.celestial(), environment.haze, pose.position.y,
                          underwater_exposure_ev(world.scene().sea.clarity_m, world.eye_depth())));
  view.clouds = cloud_view(world.scene(), world.environment(), pose.position);
  view.clouds.flash = flash_now(world.rain(), view.clouds);
  view.exposure = world.scene().exposure;
  view.boat = boat_view(world, pose.position, view.light);
  for (const Afloat& thing : world.flotsam()) {
    view.flotsam.push_back({thing.kind, glm::vec3(thing.drawn_position - pose.position),
                            glm::quat(thing.drawn_orientation)});
  }

  const double aspect = static_cast<double>(size.x) / size.y;
  const glm::mat4 clip_from_view =
      reversed_projection(world.camera().field_of_view(), aspect, kNear);
  const glm::mat4 view_from_relative = glm::mat4_cast(glm::quat(glm::conjugate(pose.orientation)));
  shared::FrameData& frame = view.frame;
  frame.clip_from_relative = clip_from_view * view_from_relative;
  frame.relative_from_clip =
      glm::mat4(glm::inverse(glm::dmat4(clip_from_view) * glm::dmat4(view_from_relative)));
  frame.viewport = {size.x, size.y, 1.0f / static_cast<float>(size.x),
                    1.0f / static_cast<float>(size.y)};
  const double pixel_angle = 2.0 * std::tan(0.5 * world.camera().field_of_view()) / size.y;
  frame.camera = {0.0f, pose.position.y, 0.0f, pixel_angle};
  const glm::dvec2 wind = environment.wind_velocity();
  frame.wind = {wind.x, environment.wind.gusts, wind.y, environment.wind.speed};
  frame.time = {std::fmod(view.sea_time, 4096.0), dt, 1.0, number};
  view.light.fill(frame);
  const FlashLight flash = flash_light(view.clouds, view.light.extinction);
  frame.flash_direction = glm::vec4(glm::dvec4(flash.direction, flash.spread));
  frame.flash_illuminance = glm::vec4(glm::dvec4(flash.illuminance, 0.0));

  view.sea_visible = sea_in_view(frame.relative_from_clip, pose.position.y);
  view.sky_visible = sky_in_view(frame.relative_from_clip, pose.position.y);
  view.underwater = underwater_view(world, pose, view.light);
  view.gardner = gardner_view(world, view.clouds, view.sky_visible);
  return view;
}

}  // namespace offing
