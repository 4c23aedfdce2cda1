// Reading the tables of the air. The includer defines `air_aerosol()`.
#include "lib/phase.glsl"
#include "lib/scattering.glsl"
#include "shared/bindings.h"

layout(binding = OFFING_UNIT_TRANSMITTANCE) uniform sampler2D transmittance_table;
layout(binding = OFFING_UNIT_MULTISCATTER) uniform sampler2D multiscatter_table;

const float kLightRadius = 0.00465;  // radians: sun and moon alike, for the earth's shadow
const vec2 kTransmittanceTexels = vec2(256.0, 64.0);
const float kMultiscatterTexels = 32.0;

// From a height to the top of the air, with no planet in the way.
vec3 table_transmittance(float height, float cosine) {
  vec2 unit = transmittance_units(height, cosine);
  vec2 at = vec2(table_from_unit(unit.x, kTransmittanceTexels.x),
                 table_from_unit(unit.y, kTransmittanceTexels.y));
  return textureLod(transmittance_table, at, 0.0).rgb;
}

// Of a light as seen from a place in the air: nothing where the planet hides it.
vec3 light_transmittance(float height, float cosine) {
  // Rays that would end in the sea have no place in the table; where the light's disc straddles the
  // horizon its upper part decides.
  float horizon = -horizon_dip_sine(height);
  return table_transmittance(height, max(cosine, horizon)) *
         soft_share_above_horizon(height, cosine, kLightRadius);
}

vec3 table_multiscatter(float height, float cosine) {
  vec2 unit = multiscatter_units(height, cosine);
  vec2 at = vec2(table_from_unit(unit.x, kMultiscatterTexels),
                 table_from_unit(unit.y, kMultiscatterTexels));
  // Logarithms: below the horizon it falls by decades from texel to texel.
  return exp(textureLod(multiscatter_table, at, 0.0).rgb);
}
