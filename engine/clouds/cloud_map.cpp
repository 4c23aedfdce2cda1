#include "engine/clouds/cloud_map.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <utility>

#include "engine/core/random.h"
#include "shaders/shared/bindings.h"

namespace offing {
namespace {

constexpr double kHighestEye = 50.0;  // m: the clouds that the water sees
// Steps that start another map: of the air's way over the boat (m), of the clouds' own change (s)
// and of the light.
constexpr double kWayStep = 10.0, kTimeStep = 4.0, kLightStep = 1e-3;
// Farther in one frame than anything moves: made anew at once.
constexpr double kLeapWay = 300.0, kLeapCosine = 0.9997;

gl::Texture map_texture(const char* label, int size) {
  return {label, {.format = GL_RGBA16F, .width = size, .height = size}};
}

ShaderDefines map_defines(const CloudMapSettings& settings) {
  return {{"STEPS", std::to_string(settings.steps)},
          {"SKIPS", "24"},
          {"FINEST", "60.0"},
          {"GROWTH", "0.02"},
          {"REACH", "60000.0"},
          {"CLOUDS_WITHOUT_CURL", "1"},
          {"WIDE_PHASE", "1"},
          {"PIXEL_ANGLE", "(1.57 / " + std::to_string(settings.size / 2) + ".0)"}};
}

}  // namespace

CloudMapSettings CloudMapSettings::of_quality(int quality) {
  constexpr CloudMapSettings kQualities[] = {
      {64, 8, 28, 2}, {96, 8, 36, 3}, {128, 12, 48, 3}, {128, 8, 64, 4}};
  return kQualities[std::clamp(quality, 0, 3)];
}

CloudMap::CloudMap(ShaderLibrary& shaders, const CloudMapSettings& settings)
    : settings_(settings),
      program_(shaders.program({"clouds/map.comp"}, map_defines(settings))),
      front_(map_texture("cloud map a", settings.size)),
      back_(map_texture("cloud map b", settings.size)),
      block_("cloud map block", sizeof(shared::CloudData)) {}

glm::ivec2 CloudMap::plan(const State& now) {
  if (working_ && rows_.x + rows_.y >= settings_.size) {
    std::swap(front_, back_);
    shown_ = coming_;
    working_ = false;
    ++version_;
  }
  const bool leap = !known_ || now.weather != shown_.weather ||
                    glm::length(now.air - shown_.air) > kLeapWay ||
                    glm::dot(now.light, shown_.light) < kLeapCosine;
  const int share = (settings_.size + settings_.slices - 1) / settings_.slices;
  if (leap && !working_) {
    shown_ = now;
    ++version_;
    known_ = true;
    return {0, settings_.size};
  }
  if (working_) {
    const int first = rows_.x + rows_.y;
    return {first, std::min(share, settings_.size - first)};
  }
  if (now.moment == shown_.moment) return {0, 0};
  coming_ = now;
  working_ = true;
  return {0, share};
}

std::optional<ProbeClouds> CloudMap::add(FrameGraph& graph, const CloudField& field,
                                         const CloudIds& ids, const Sky& sky, const SkyIds& sky_ids,
                                         const CloudShadow& shadow,
                                         const CloudShadowIds& shadow_ids, const CloudView& view,
                                         const SkyLight& light, const shared::CloudData& data) {
  const bool any = view.weather.cover > 0.0;
  bool whole = false;
  rows_ = any ? rows_ : glm::ivec2(0);
  if (any) {
    State now;
    now.weather =
        hash_of(view.weather, data.layer, data.form, data.box.z, data.box.w, data.light, data.phase,
                data.ambient, data.march.y, view.seed, light.haze, program_.generation(),
                std::hash<std::string>()(view.parameters.weather_picture));
    now.air = glm::dvec2(view.eye.x, view.eye.z) - cloud_carried(view, data.layer.w);
    now.light = glm::normalize(glm::dvec3(data.light_direction));
    now.moment = hash_of(now.weather, glm::round(now.air / kWayStep),
                         glm::round(now.light / kLightStep), std::floor(view.elapsed / kTimeStep));
    rows_ = plan(now);
    whole = rows_.y == settings_.size;
  } else {
    known_ = working_ = false;
  }

  CloudView low = view;
  low.eye.y = std::clamp(view.eye.y, 1.0, kHighestEye);
  shared::CloudData seen = cloud_data(low, light);
  seen.shadow = data.shadow;
  seen.shadow_light = data.shadow_light;
  const BufferId block = graph.import(block_);
  CloudIds map_field = ids;
  map_field.block = block;
  CloudShadowIds map_shadow = shadow_ids;
  map_shadow.block = block;
  const gl::Texture& target = whole ? front_ : back_;
  const TextureId front = graph.import(front_), written = graph.import(target);
  graph.add(
      "clouds.map",
      [&](PassBuilder& pass) {
        pass.write(block, Access::kTransfer);
        if (whole) {
          pass.write(written);
        } else {
          pass.modify(written, Access::kImage).side_effect();
        }
        pass.cached_if(any && rows_.y == 0).skip_if(!any);
        if (rows_.y == 0) return;
        ids.read_by(pass);
        sky_ids.read_by(pass);
        shadow_ids.read_by(pass);
      },
      [this, &field, &sky, &shadow, &target, sky_ids, map_field, map_shadow, seen,
       rows = rows_](const PassContext& context) {
        block_.write(seen);
        sky.bind(context, sky_ids);
        field.bind(context, map_field);
        shadow.bind(context, map_shadow);
        program_.use();
        program_.program().set(0, rows);
        program_.program().set(1, settings_.light_steps);
        target.bind_image(0, GL_WRITE_ONLY);
        glDispatchCompute(static_cast<GLuint>((settings_.size + 7) / 8),
                          static_cast<GLuint>((rows.y + 7) / 8), 1);
      });
  if (!any) return {};
  return ProbeClouds{front, version_};
}

}  // namespace offing
