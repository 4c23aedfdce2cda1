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

// Mean radiance (cd/m^2) that a surface of this roughness mirrors from `direction` (unit): that of a
// GGX surface of width alpha = roughness^2 seen along its normal (Karis 2013).
vec3 probe_radiance(vec3 direction, float roughness) {
  vec2 units = probe_units(direction);
  float below = direction.y < 0.0 ? 1.0 : 0.0;
  const float kSteps = float(kProbeLevels - 1);
  float rough = probe_level(clamp(roughness, 0.0, 1.0)) * kSteps;
  int first = min(int(rough), kProbeLevels - 2);
  // Next to the mirror by the square, which is how a small blur grows.
  float share = rough - float(first);
  share = first == 0 ? share * share : share;
  vec3 radiance = frame.sky_illuminance.rgb * mix(probe_read(first, units, below),
                                                  probe_read(first + 1, units, below), share);
  for (int i = 0; i < int(frame.flash_direction.w > 0.0); ++i) {
    radiance += flash_mirrored(direction, roughness * roughness);
  }
  return radiance;
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
