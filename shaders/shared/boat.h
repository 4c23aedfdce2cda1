// The boat as her shaders see her. One struct for C++ and GLSL (std140: vec4 and mat4 only).
// Boat frame: x starboard, y up, z aft, origin at the design waterline amidships.
#ifdef __cplusplus
#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
namespace offing::shared {
using glm::mat4;
using glm::vec4;
#define OFFING_CONST inline constexpr
#else
#define OFFING_CONST const
#endif

OFFING_CONST int kBoatNodes = 24;
OFFING_CONST int kBoatMaterials = 32;
#undef OFFING_CONST

struct BoatMaterial {
  vec4 base_colour;  // linear sRGB; w: metallic 0 to 1
  vec4 emission;     // luminance at night, cd/m^2; w: GGX alpha
};

struct BoatData {
  mat4 relative_from_boat;
  mat4 boat_from_node[kBoatNodes];
  BoatMaterial materials[kBoatMaterials];
};

#ifdef __cplusplus
static_assert(sizeof(BoatData) == 64 + 64 * kBoatNodes + 32 * kBoatMaterials);
}  // namespace offing::shared
#else
#include "shared/bindings.h"
layout(std140, binding = OFFING_BIND_BOAT) uniform BoatBlock { BoatData boat; };
#endif
