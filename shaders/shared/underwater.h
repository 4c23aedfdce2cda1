// What the shaders of the view under water share with C++ (std140: vec4 only).
#ifdef __cplusplus
#pragma once
#include <glm/vec4.hpp>
namespace offing::shared {
using glm::vec4;
#endif

// Depths (m) at which the light of the waves is gathered: kCausticFirst × kCausticRatio^layer.
const int kCausticLayers = 4;
const float kCausticFirst = 0.35f;
const float kCausticRatio = 3.0f;

struct UnderwaterData {
  vec4 beam;     // rgb: attenuation of the picture (1/m); w: depth of the eye (m), 0 above
  vec4 diffuse;  // rgb: attenuation of daylight with depth (1/m)
  vec4 glow;     // rgb: radiance of the depths, seen straight down, over the illuminance there
  vec4 once;     // rgb: light scattered once toward an eye that looks down, 1/m, over the illuminance
  vec4 light;    // xyz: toward the brighter of sun and moon, as bent by level water; w: its illuminance
                 // below on a plane that faces it, over that above
  vec4 bright;   // rgb: that light's illuminance above, lux; w: 1 where it makes caustics, else 0
  vec4 above;    // xyz: toward it, above the water; w: 1 where the boat may be in view, else 0
  vec4 caustics; // x, y: middle of the map (x, z relative to the camera), z: its width (m), w: texels
  vec4 photons;  // x, y: first photon at rest, relative to the camera; z: between them (m); w: a row
};

#ifdef __cplusplus
}  // namespace offing::shared
#else
layout(std140, binding = OFFING_BIND_UNDERWATER) uniform UnderwaterBlock { UnderwaterData water; };
#endif
