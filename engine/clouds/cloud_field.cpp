#include "engine/clouds/cloud_field.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "engine/clouds/lightning.h"
#include "engine/core/random.h"
#include "shaders/shared/bindings.h"

#define OFFING_GLSL "shaders/lib/clouds.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

constexpr double kEarthDiameter = 2.0 * 6.36e6;  // m, as in lib/scattering.glsl
// Periods without a common multiple within sight, m.
constexpr double kShapePeriod = 3300.0, kDetailPeriod = 260.0, kCurlPeriod = 1900.0;
constexpr double kCurlReach = 90.0;
/// Bases of different clouds lie this far apart at most, by type, m.
constexpr double kBaseSpread = 190.0;
constexpr double kHuge = 1e7;
/// A ray that is outside by one of the field goes on this far, m. Rolls have steeper sides, storms
/// wider ones, and kilometres of air beneath what overhangs: shorter, a ray has no steps left when
/// it comes to them.
constexpr double kSureWay = 260.0;

double fraction(double x) { return x - std::floor(x); }

glm::vec4 pack(const glm::dvec3& v, double w) { return {glm::vec3(v), static_cast<float>(w)}; }
glm::vec4 pack(double x, double y, double z, double w) { return glm::vec4(glm::dvec4(x, y, z, w)); }

}  // namespace

shared::CloudData cloud_data(const CloudView& view, const SkyLight& light) {
  const CloudParameters& p = view.parameters;
  const Clouds& weather = view.weather;
  shared::CloudData data{};

  const double type = weather.type;
  const double base = cloud_base(view);
  const double spread = kBaseSpread * glsl::cloud_blend(0.25, 0.6, 1.0, type) * base / 700.0;
  const double tallest = tallest_cloud(weather);
  data.eye = pack(view.eye.y, 1.0 / kEarthDiameter, weather.cover > 0.0 ? 1.0 : 0.0,
                  tallest_storm(weather));
  data.layer =
      pack(base - spread, base + spread + 1.06 * tallest * p.scale, p.extinction * p.density, base);

  const glm::dvec2 carried = cloud_carried(view, base);
  const glm::dvec2 w = weather_place(view);
  data.weather =
      pack(w.x, w.y, 1.0 / (WeatherMap::kPeriod * p.scale), glsl::weather_threshold(weather.cover));
  // The body's noise rises and drifts ahead a little: clouds boil.
  const double rise = 0.7 * p.evolution * view.elapsed;
  glm::dvec3 s = pattern_place(view, carried * 1.02, kShapePeriod * p.scale, 1);
  s.y = fraction(s.y - rise / (kShapePeriod * p.scale));
  data.shape = pack(s, 1.0 / (kShapePeriod * p.scale));
  glm::dvec3 d = pattern_place(view, carried, kDetailPeriod * p.scale, 2);
  d.y = fraction(d.y - 1.3 * rise / (kDetailPeriod * p.scale));
  data.detail = pack(d, 1.0 / (kDetailPeriod * p.scale));
  const glm::dvec3 c = pattern_place(view, carried, kCurlPeriod * p.scale, 3);
  data.curl = pack(c.x, c.z, 1.0 / (kCurlPeriod * p.scale), kCurlReach * p.curl * p.scale);
  data.form = pack(p.density_threshold, p.roughness, p.erosion, p.scale);

  const glm::dvec2 along = turned(view.wind_to, p.direction_offset_deg);
  data.wind = pack(along.x, along.y, cloud_shear(view), weather.precipitation);
  const bool box = p.container == static_cast<int>(CloudContainer::kBox);
  data.box = pack(box ? -view.eye.x : 0.0, box ? -view.eye.z : 0.0,
                  box ? 500.0 * p.box_size : kHuge, 1e-3 / p.edge_fade);

  const double to_sun = glm::dot(light.sun_illuminance, glm::dvec3(0.2126, 0.7152, 0.0722));
  const double to_moon = glm::dot(light.moon_illuminance, glm::dvec3(0.2126, 0.7152, 0.0722));
  // Clouds see a sun that has set here: it lights them from below for some minutes more.
  const bool sun = light.sun_direction.y > -0.06 || to_sun >= to_moon;
  data.light_direction = pack(sun ? light.sun_direction : light.moon_direction, 0.0);
  data.light_source = pack(sun ? light.sun_source : light.moon_source, 0.0);
  data.light = pack(p.sun_absorption, p.cloud_absorption, p.darkness_floor, p.brightness);
  data.phase = pack(p.forward_scattering, p.back_scattering, p.back_share, p.phase_weight);
  data.ambient = pack(p.powder, p.ambient, 0.0, 0.0);

  data.march = pack(
      p.step_scale, p.phase == static_cast<int>(CloudPhase::kDroplets) ? p.droplets_um : 0.0,
      kSureWay * glsl::cloud_blend(1.0, 0.5, data.eye.w > 0.0f ? 2.0 : 1.0, type) * p.scale, 0.0);
  data.flash = pack(flash_place(view), view.flash.candela);
  return data;
}

void CloudIds::read_by(PassBuilder& pass) const {
  pass.read(shape).read(detail).read(curl).read(weather).read(most).read(block, Access::kUniform);
}

CloudField::CloudField(ShaderLibrary& shaders)
    : noise_(shaders),
      weather_(shaders),
      volume_("clouds volume", GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR, GL_REPEAT, GL_REPEAT),
      plane_("clouds plane", GL_LINEAR, GL_LINEAR, GL_REPEAT, GL_REPEAT),
      nearest_("clouds cells", GL_NEAREST, GL_NEAREST, GL_REPEAT, GL_REPEAT),
      block_("clouds block", sizeof(shared::CloudData)) {
  glSamplerParameteri(volume_.id(), GL_TEXTURE_WRAP_R, GL_REPEAT);
}

CloudIds CloudField::add(FrameGraph& graph, const CloudView& view, const shared::CloudData& data) {
  lowest_base_ = data.layer.x;
  highest_top_ = data.layer.y;
  const CloudParameters& p = view.parameters;
  state_ = hash_of(data, view.weather, view.elapsed, view.seed, p.shape_weights, p.detail_weights,
                   std::hash<std::string>()(p.weather_picture));
  const CloudNoise::Ids noise = noise_.add(graph, view.parameters);
  const WeatherMap::Ids weather =
      weather_.add(graph, noise.weather, view.weather, view.elapsed, view.parameters, view.seed);
  const CloudIds ids{noise.shape,     noise.detail, noise.curl,
                     weather.weather, weather.most, graph.import(block_)};
  graph.add(
      "clouds.block",
      [&](PassBuilder& pass) {
        pass.write(ids.block, Access::kTransfer)
            .cache(block_memory_, hash_bytes(&data, sizeof(data)));
      },
      [this, data](PassContext&) { block_.write(data); });
  return ids;
}

void CloudField::bind(const PassContext& context, const CloudIds& ids) const {
  const auto bind = [&](TextureId id, const gl::Sampler& sampler, GLuint unit) {
    context.texture(id).bind(unit);
    sampler.bind(unit);
  };
  bind(ids.shape, volume_, OFFING_UNIT_CLOUD_SHAPE);
  bind(ids.detail, volume_, OFFING_UNIT_CLOUD_DETAIL);
  bind(ids.curl, plane_, OFFING_UNIT_CLOUD_CURL);
  bind(ids.weather, plane_, OFFING_UNIT_CLOUD_WEATHER);
  bind(ids.most, nearest_, OFFING_UNIT_CLOUD_MOST);
  context.buffer(ids.block).bind_uniform(OFFING_BIND_CLOUDS);
}

}  // namespace offing
