#pragma once
#include "engine/gl/buffer.h"
#include "engine/gl/texture.h"
#include "engine/ocean/ocean.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/clouds.h"
#include "shaders/shared/probe.h"
#include "shaders/shared/sky.h"

namespace offing::test {

/// Light for tests of what is lit by it: a probe with the same light from all round, of which a
/// level surface gets FrameData's sky_illuminance; no clouds; air that neither takes nor gives
/// light.
class EvenLight {
 public:
  EvenLight() : map_("even light", {.format = GL_RGBA32F, .width = 2, .height = 1}) {
    constexpr float kRadiance = 0.3183099f;  // over the illuminance
    const float texels[8] = {kRadiance, kRadiance, kRadiance, 1,
                             kRadiance, kRadiance, kRadiance, 1};
    map_.upload(GL_RGBA, GL_FLOAT, texels);
    shared::ProbeData data{};
    for (glm::vec4& level : data.levels) level = {0.0f, 0.0f, 1.0f, 0.0f};
    data.texel = {0.5f, 1.0f, 0.0f, 0.0f};
    data.irradiance[0] = glm::vec4(1.0f / 0.28209479f);
    block_ = gl::Buffer("even light", sizeof(data), GL_DYNAMIC_STORAGE_BIT, &data);
    shared::CloudData clouds{};
    clouds.shadow_light = {0.0f, 1.0f, 0.0f, 0.0f};
    clouds_ = gl::Buffer("clear sky", sizeof(clouds), GL_DYNAMIC_STORAGE_BIT, &clouds);
    shared::SkyData sky{};
    sky.observer = {0.0f, 0.0f, 1.0f, 0.0f};
    sky.azimuths = {1.0f, 0.0f, 1.0f, 0.0f};
    sky.table_texels = {2.0f, 1.0f, 2.0f, 1.0f};
    sky.lights.z = 1.0f;
    sky_ = gl::Buffer("black sky", sizeof(sky), GL_DYNAMIC_STORAGE_BIT, &sky);
  }

  LightAccess access() const {
    return {[](PassBuilder&) {},
            [this](const PassContext&) {
              map_.bind(OFFING_UNIT_PROBE);
              map_.bind(OFFING_UNIT_SKY_SUN);
              map_.bind(OFFING_UNIT_SKY_MOON);
              map_.bind(OFFING_UNIT_CLOUD_SHADOW);
              block_.bind_uniform(OFFING_BIND_PROBE);
              clouds_.bind_uniform(OFFING_BIND_CLOUDS);
              sky_.bind_uniform(OFFING_BIND_SKY);
            }};
  }

 private:
  gl::Texture map_;
  gl::Buffer block_, clouds_, sky_;
};

}  // namespace offing::test
