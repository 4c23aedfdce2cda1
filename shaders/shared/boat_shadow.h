// The boat's shadow map. One struct for C++ and GLSL (std140: vec4 and mat4 only).
#ifdef __cplusplus
#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
namespace offing::shared {
using glm::mat4;
using glm::vec4;
#endif

struct BoatShadowData {
  mat4 map_from_relative;  // to 0 … 1 across the map and away from the light
  vec4 light;              // xyz: toward it; w: which casts: 0 the sun, 1 the moon, -1 neither
  vec4 map;                // x: taps, 1 or 4; y: a texel over the side of one half; z: 1 m of depth; w: share of light through cloth
};

#ifdef __cplusplus
static_assert(sizeof(BoatShadowData) == 96);
}  // namespace offing::shared
#else
#include "shared/bindings.h"
layout(std140, binding = OFFING_BIND_BOAT_SHADOW) uniform BoatShadowBlock { BoatShadowData boat_shadow; };
#endif
