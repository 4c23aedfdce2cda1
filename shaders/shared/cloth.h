// How one cloth (a sail, a flag) moves and looks. One struct for C++ and GLSL (std140: vec4 only).
// Cloth frame: y up the luff or hoist, z toward the leech or fly, x its normal; u runs with z, v with y.
#ifdef __cplusplus
#pragma once
#include <glm/vec4.hpp>
namespace offing::shared {
using glm::vec4;
#endif

struct ClothParameters {
  vec4 clock;            // x: time (s), already stepped and offset; y: waves per metre of cloth; z: their speed (m/s); w: their height (m)
  vec4 gradient_weight;  // xyz: how much of the noise moves the cloth along x, y, z; w: 0 calm … 1 shaking from the leech
  vec4 belly;            // x: depth over chord, + toward +x; y: twist (rad, + toward +x) at the head; z: place of the deepest point, 0 to 1; w: node index
  vec4 attached;         // how firmly each edge is held, 0 free … 1 fixed: luff, leech, foot, head
  vec4 stream;           // xyz: unit, where the cloth's chord points in its frame (0, 0, 1 for a sail); w: share of the belly left at the foot
  vec4 colour_a;         // rgb: linear, where the pattern is 0; w: share of light let through
  vec4 colour_b;         // rgb: linear, where the pattern is 1; w: unused
};

#ifdef __cplusplus
static_assert(sizeof(ClothParameters) == 112);
}  // namespace offing::shared
#else
#include "shared/bindings.h"
layout(std140, binding = OFFING_BIND_CLOTH) uniform ClothBlock { ClothParameters cloth; };
#endif
