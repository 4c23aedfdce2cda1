// Where in the probe's picture its parts lie, and its irradiance. One struct for C++ and GLSL (std140).
#ifdef __cplusplus
#pragma once
#include <glm/vec4.hpp>
namespace offing::shared {
using glm::vec4;
#endif

const int kProbeLevels = 13;  // of roughness: see lib/probe.glsl
const int kProbeHarmonics = 10;

struct ProbeData {
  // x, y: first texel; z: texels per side of its two squares, above the level and, right of it, below;
  // w: GGX width, 0 for the mirror
  vec4 levels[kProbeLevels];
  vec4 texel;          // x, y: size of a texel in texture coordinates
  vec4 irradiance[kProbeHarmonics];  // spherical harmonics (lib/probe.glsl), over the sky's level illuminance
};

#ifdef __cplusplus
static_assert(sizeof(ProbeData) == 24 * 16);
}  // namespace offing::shared
#endif
