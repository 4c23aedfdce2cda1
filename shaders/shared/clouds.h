// What the clouds' shaders share with C++ (std140: vec4 and mat4 only). Needs shared/bindings.h.
//
// Places are relative to the camera (m). Coordinates of textures that repeat are given for the
// camera's own place, less whole periods, which only the CPU, in double, knows.
#ifdef __cplusplus
#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
namespace offing::shared {
using glm::mat4;
using glm::vec4;
#endif

struct CloudData {
  vec4 eye;       // x: height of the camera (m); y: 1 / earth's diameter (1/m); z: 1 where there are clouds; w: thickness of storms (m), 0: none
  vec4 weather;   // xy: coordinates at the camera; z: 1 / period (1/m); w: weather_threshold() of the cover
  vec4 shape;     // xyz: coordinates at the camera; w: 1 / period (1/m)
  vec4 detail;    // likewise
  vec4 curl;      // xy: coordinates at the camera; z: 1 / period (1/m); w: reach at the bases (m)
  vec4 layer;     // x: lowest base, y: highest top (m over the sea); z: extinction (1/m); w: base of the parameters (m)
  vec4 form;      // x: shift of the edge; y: strength of the body's noise; z: of the edges'; w: scale
  vec4 wind;      // xy: unit (x, z) along the wind aloft; z: lean (m per m); w: precipitation, 0 … 1
  vec4 box;       // xy: its middle (x, z) from the camera; z: half a side (m; a shell: huge); w: 1 / edge fade (1/m)
  vec4 light_direction;  // xyz: toward the brighter of sun and moon; w: unused
  vec4 light_source;     // rgb: its lux above the air; w: unused
  vec4 light;     // x: absorption on the way in, y: out; z: least share of the sunlight; w: brightness
  vec4 phase;     // x: g forward, y: g backward (positive), z: share backward, w: weight against even scattering
  vec4 ambient;   // x: powder; y: strength of ambient light; z, w: unused
  vec4 march;  // x: length of the steps over their usual one; y: diameter of the droplets (um), 0: two lobes; z: way to an edge that is sure for one of the field outside it (m); w: unused
  vec4 shadow_light;  // xyz: toward the light that the shadow map was made for, not flat; w: unused
  vec4 shadow;    // xy: middle of the shadow map from the camera (x, z; m); z: 1 / its side (1/m); w: its height (m over the sea)
  vec4 flash;     // xyz: place of the lightning from the camera (m); w: its luminous intensity (cd), 0: none
};

#ifdef __cplusplus
static_assert(sizeof(CloudData) == 18 * 16);
}  // namespace offing::shared
#else
layout(std140, binding = OFFING_BIND_CLOUDS) uniform CloudBlock { CloudData clouds; };
#endif
