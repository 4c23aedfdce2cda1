#pragma once
#include "engine/gl/buffer.h"
#include "engine/gl/texture.h"
#include "engine/ocean/ocean.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/probe.h"

namespace offing::test {

/// A probe for tests of what is lit by it: the same light from all round, of which a level surface
/// gets FrameData's sky_illuminance.
class EvenLight {
 public:
  EvenLight() : map_("even light", {.format = GL_RGBA32F, .width = 2, .height = 1}) {
    constexpr float kRadiance = 0.3183099f;  // over the illuminance
    const float texels[8] = {kRadiance, kRadiance, kRadiance, 1, kRadiance, kRadiance, kRadiance,
                             1};
    map_.upload(GL_RGBA, GL_FLOAT, texels);
    shared::ProbeData data{};
    for (glm::vec4& level : data.levels) level = {0.0f, 0.0f, 1.0f, 0.0f};
    data.texel = {0.5f, 1.0f, 0.0f, 0.0f};
    data.irradiance[0] = glm::vec4(1.0f / 0.28209479f);
    block_ = gl::Buffer("even light", sizeof(data), GL_DYNAMIC_STORAGE_BIT, &data);
  }

  LightAccess access() const {
    return {[](PassBuilder&) {},
            [this](const PassContext&) {
              map_.bind(OFFING_UNIT_PROBE);
              block_.bind_uniform(OFFING_BIND_PROBE);
            }};
  }

 private:
  gl::Texture map_;
  gl::Buffer block_;
};

}  // namespace offing::test
