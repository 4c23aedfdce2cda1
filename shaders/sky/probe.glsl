// The light that arrives at the boat from all round, as reflections and as irradiance: sky and clouds
// above, a mean sea below, and lightning, without the discs of sun and moon. Needs shared/frame.h before it, and of
// the C++ side ProbeIds::read_by() and Probe::bind().
//
// The probe holds radiance over the sky's illuminance of a level surface, channel by channel: half
// floats then hold noon and night alike, and a probe some frames old still has today's brightness.
#include "lib/flash.glsl"
#include "lib/probe.glsl"
#include "shared/bindings.h"
#include "shared/probe.h"

layout(binding = OFFING_UNIT_PROBE) uniform sampler2D probe_map;
layout(std140, binding = OFFING_BIND_PROBE) uniform ProbeBlock { ProbeData probe; };

vec3 probe_read(int level, vec2 units, float below) {
  vec3 place = probe.levels[level].xyz;
  vec2 at = place.xy + 0.5 + units * (place.z - 1.0) + vec2(below * place.z, 0.0);
  return textureLod(probe_map, at * probe.texel.xy, 0.0).rgb;
}

vec3 with_flash(vec3 radiance, vec3 direction, float roughness) {
  for (int i = 0; i < int(frame.flash_direction.w > 0.0); ++i) {
    radiance += flash_mirrored(direction, roughness * roughness);
  }
  return radiance;
}

// Mean radiance (cd/m^2) that a surface of this roughness mirrors from `direction` (unit): that of a
// GGX surface of width alpha = roughness^2 seen along its normal (Karis 2013).
vec3 probe_radiance(vec3 direction, float roughness) {
  vec2 units = probe_units(direction);
  float below = direction.y < 0.0 ? 1.0 : 0.0;
  float level = probe_level(min(roughness * roughness, 1.0));
  int first = min(int(level), kProbeLevels - 2);
  return with_flash(frame.sky_illuminance.rgb * mix(probe_read(first, units, below),
                                                    probe_read(first + 1, units, below),
                                                    level - float(first)),
                    direction, roughness);
}

// One of the two levels that make up probe_radiance(), by chance in proportion; `die`: even over 0 … 1. For
// surfaces no smoother than a sea without wind.
vec3 probe_radiance_picked(vec3 direction, float roughness, float die) {
  int level = min(int(probe_level_rough(min(roughness * roughness, 1.0)) + die), kProbeLevels - 1);
  return with_flash(frame.sky_illuminance.rgb *
                        probe_read(level, probe_units(direction), direction.y < 0.0 ? 1.0 : 0.0),
                    direction, roughness);
}

// Illuminance (lux) of a surface with this normal (unit) from sky, clouds and sea, without the light
// that comes straight from sun and moon.
vec3 probe_irradiance(vec3 normal) {
  ProbeBasis b = probe_basis(normal);
  vec3 sum = b.constant * probe.irradiance[0].rgb + b.linear.x * probe.irradiance[1].rgb +
             b.linear.y * probe.irradiance[2].rgb + b.linear.z * probe.irradiance[3].rgb +
             b.product.x * probe.irradiance[4].rgb + b.product.y * probe.irradiance[5].rgb +
             b.product.z * probe.irradiance[6].rgb + b.zonal * probe.irradiance[7].rgb +
             b.sectoral * probe.irradiance[8].rgb + b.ring * probe.irradiance[9].rgb;
  vec3 lux = frame.sky_illuminance.rgb * max(sum, vec3(0.0));
  for (int i = 0; i < int(frame.flash_direction.w > 0.0); ++i) lux += flash_illuminance(normal);
  return lux;
}
