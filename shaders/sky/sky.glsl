// The sky's light for everything that is lit by it or reflects it. Needs shared/frame.h before it,
// and of the C++ side Sky::bind() and SkyIds::read_by().
#include "lib/phase.glsl"
#include "lib/scattering.glsl"
#include "shared/bindings.h"
#include "shared/sky.h"

layout(binding = OFFING_UNIT_SKY_SUN) uniform sampler2D sky_sun_table;
layout(binding = OFFING_UNIT_SKY_MOON) uniform sampler2D sky_moon_table;

#include "sky/palette.glsl"

// What there is of the sky, each 0 or 1, as bounds of loops: a CPU renderer runs both sides of an if, and
// by day half the cost of the sky would be a moon that nobody sees. Loops cost as much as what they hold
// unless their bounds are known when they are compiled: a pass of many pixels has a program for each sky
// (see Sky::background_program()).
#ifndef SKY_MOON
#define SKY_MOON int(sky.lights.x)
#define SKY_AIR int(sky.lights.z)
#define SKY_PAINTED int(sky.lights.w)
#endif

vec2 sky_table_at(float cosine_azimuth, float sine_above_horizon) {
  vec2 unit = sky_view_units(cosine_azimuth, sine_above_horizon);
  return 0.5 / sky.table_texels.xy + unit * (1.0 - 1.0 / sky.table_texels.xy);
}

// What the air alone makes of sun, moon and its own glow.
vec3 physical_sky_radiance(vec3 direction) {
  float flat_length2 = max(dot(direction.xz, direction.xz), 1.0e-12);
  vec2 heading = direction.xz * inversesqrt(flat_length2);
  float above = max(direction.y * sky.observer.z + sqrt(flat_length2) * sky.observer.y, 0.0);
  vec4 sun = textureLod(sky_sun_table, sky_table_at(dot(heading, sky.azimuths.xy), above), 0.0);
  vec3 radiance = sun.rgb * sky.sun_source.rgb + sun.a * sky.night.rgb + umbra_band(above) * sky.umbra.rgb;
  for (int i = 0; i < SKY_MOON; ++i) {
    vec2 at = sky_table_at(dot(heading, sky.azimuths.zw), above);
    radiance += textureLod(sky_moon_table, at, 0.0).rgb * sky.moon_source.rgb;
  }
  return radiance;
}

// Radiance of the sky in cd/m^2 as linear sRGB, without discs and stars. A direction below the sea's
// horizon gets the sky at the horizon there, so what fades into the distance fades into the sky.
vec3 sky_radiance(vec3 direction) {
  vec3 radiance = vec3(0.0);
  for (int i = 0; i < SKY_AIR; ++i) radiance = physical_sky_radiance(direction);
  for (int i = 0; i < SKY_PAINTED; ++i) radiance = painted_sky_radiance(direction, radiance);
  return radiance;
}

// Illuminance in lux of the sky without discs on a surface of this normal: the measured value of a
// level surface, shared out as if the sky were even, with the sea's dim light from below.
vec3 sky_irradiance(vec3 normal) {
  float up = 0.5 + 0.5 * normal.y;
  return frame.sky_illuminance.rgb * mix(kSeaAlbedo, 1.0, up);
}

// Air between the eye and a thing at this distance (m) near the sea: seen = thing × transmittance +
// inscattered.
struct AirLight {
  vec3 transmittance;
  vec3 inscattered;
};
AirLight air_light(vec3 direction, float distance) {
  AirLight air;
  air.transmittance = exp(-frame.haze.rgb * distance);
  // Air that fills the view to the horizon looks as the horizon does.
  vec3 level = vec3(direction.x, 0.0, direction.z);
  air.inscattered = sky_radiance(level - vec3(0.0, sky.observer.y, 0.0)) *
                    (vec3(1.0) - air.transmittance);
  return air;
}
