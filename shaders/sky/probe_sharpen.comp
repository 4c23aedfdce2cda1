// A level of the probe so that what is read between texels and between levels is right in the mean. Where a
// quantity bends by b over a step, a straight line between its values is too high by b t (1 - t) / 2, in the
// mean b / 12: taken off the values, the root mean square of what is left is 0.4 of what it was. Where it bends by
// more than such a line can follow, as at the edges of clouds, no more than 6 % is taken off.
#include "lib/probe.glsl"
#include "shared/bindings.h"
#include "shared/probe.h"

layout(local_size_x = 16, local_size_y = 4) in;
layout(rgba16f, binding = 0) uniform writeonly image2D map;
layout(binding = 3) uniform sampler2D sums;  // the levels as they are, laid out as the map
layout(std140, binding = OFFING_BIND_PROBE) uniform ProbeBlock { ProbeData probe; };
layout(location = 0) uniform ivec4 region;  // to make: first texel, texels per side, first row
layout(location = 1) uniform int level;

vec3 value(ivec2 at) { return texelFetch(sums, at, 0).rgb; }

vec3 of_level(int i, vec2 units, float below) {
  vec3 place = probe.levels[i].xyz;
  vec2 at = place.xy + 0.5 + units * (place.z - 1.0) + vec2(below * place.z, 0.0);
  return textureLod(sums, at * probe.texel.xy, 0.0).rgb;
}

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, region.w);
  if (texel.x >= 2 * region.z || texel.y >= region.z) return;
  bool below = texel.x >= region.z;
  ivec2 within = texel - ivec2(below ? region.z : 0, 0), at = region.xy + texel;
  vec3 here = value(at), bend = vec3(0.0);
  for (int i = 0; i < 2; ++i) {
    ivec2 next = ivec2(1 - i, i);
    float inside = within[i] > 0 && within[i] < region.z - 1 ? 1.0 : 0.0;
    bend += inside * (value(at - next) - 2.0 * here + value(at + next));
  }
  // The first two steps of roughness are uneven.
  for (int i = 0; i < int(level > 2 && level < kProbeLevels - 1); ++i) {
    vec2 units = vec2(within) / float(region.z - 1);
    float side = below ? 1.0 : 0.0;
    bend += of_level(level - 1, units, side) - 2.0 * here + of_level(level + 1, units, side);
  }
  imageStore(map, at, vec4(clamp(here - bend / 12.0, 0.94 * here, 1.06 * here), 1.0));
}
