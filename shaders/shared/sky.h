// What the shaders that ask for the sky's light need to know. One struct for C++ and GLSL (std140).
#ifdef __cplusplus
#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
namespace offing::shared {
using glm::mat4;
using glm::vec4;
#endif

struct SkyData {
  vec4 sun_source;    // rgb: lux above the air, less what the moon covers; w: share left uncovered
  vec4 moon_source;   // rgb: lux above the air for the present phase and shadow; w: luminance of the sunlit disc, cd/m^2
  vec4 azimuths;      // xy: unit (x, z) toward the sun, zw: toward the moon
  vec4 night;         // rgb: airglow at the zenith, cd/m^2; w: earthshine on the dark moon, cd/m^2
  vec4 umbra;         // rgb: light at the horizon from outside the moon's shadow, cd/m^2
  vec4 observer;      // x: height km, y: sine, z: cosine of the horizon's dip, w: share of stars shown
  vec4 aerosol;       // xyz: struct Aerosol of lib/scattering.glsl
  vec4 lights;        // x: 1 where the moon lights the sky visibly, else 0; y: strength of a grade;
                      // z: 1 where there is air, 0 where the sky is only painted; w: 1 where it is painted
  vec4 table_texels;  // xy: size of the sky views, zw: size of the transmittance table
  vec4 palette_zenith;   // rgb: cd/m^2 (or, where there is air, a tint of luminance 1)
  vec4 palette_middle;   // likewise
  vec4 palette_horizon;  // likewise
  mat4 world_from_j2000;  // turns the stars
};

#ifdef __cplusplus
static_assert(sizeof(SkyData) == 256);
}  // namespace offing::shared
#else
layout(std140, binding = OFFING_BIND_SKY) uniform SkyBlock { SkyData sky; };
#endif
