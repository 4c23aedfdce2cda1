// What Gardner's clouds share with C++ (std140: vec4 only). A pass's own block.
#ifdef __cplusplus
#pragma once
#include <glm/vec4.hpp>
namespace offing::shared {
using glm::vec4;
#endif

struct GardnerData {
  vec4 light_direction;  // xyz: toward the brighter of sun and moon
  vec4 light_source;     // rgb: its lux above the air
  vec4 high;       // xy: place of the camera along and across the wind, in wavelengths; z: 1 / wavelength (1/m); w: height (m)
  vec4 high_wind;  // xy: unit (x, z) along the wind; z: how much longer than wide the pattern is; w: T0
  vec4 high_form;  // x: T1, y: D, z: optical depth where it is densest, 0: none; w: terms
  vec4 middle;       // of altocumulus, as `high`
  vec4 middle_form;  // x: what its texture exceeds over its share of the sky; y: its greatest optical depth, 0: none; zw: unused
  vec4 shading;    // of ellipsoids: a, t, s of (8); w: T0
  vec4 translucency;  // of ellipsoids: T1, T2, D of (11); w: terms
  vec4 pattern;       // of ellipsoids: xyz: place of the camera in wavelengths; w: 1 / wavelength (1/m)
};

#ifdef __cplusplus
static_assert(sizeof(GardnerData) == 10 * 16);
}  // namespace offing::shared
#else
#include "shared/bindings.h"
layout(std140, binding = OFFING_BIND_GARDNER) uniform GardnerBlock { GardnerData gardner; };
#endif
