// A level of the probe so that what is read between texels and between levels is right in the mean. Where a
// quantity bends by b over a step, a straight line between its values is too high by b t (1 - t) / 2, in the
// mean b / 12: taken off the values, the root mean square of what is left is 0.4 of what it was. Where it bends by
// more than such a line can follow, as at the edges of clouds, no more than a quarter is taken off; of the level
// whose lobe is narrower than a texel, no more than 6 %.
#include "sky/probe_tile.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f, binding = 0) uniform writeonly image2D map;
layout(binding = 3) uniform sampler2D sums;  // the levels as they are, laid out as the map

vec3 value(ivec2 at) { return texelFetch(sums, at, 0).rgb; }

vec3 of_level(int i, vec2 units, float below) {
  vec3 place = probe.levels[i].xyz;
  vec2 at = place.xy + 0.5 + units * (place.z - 1.0) + vec2(below * place.z, 0.0);
  return textureLod(sums, at * probe.texel.xy, 0.0).rgb;
}

void main() {
  ProbeTile tile = this_tile();
  ivec2 within = tile.corner + ivec2(gl_LocalInvocationID.xy);
  if (any(greaterThanEqual(within, ivec2(tile.side)))) return;
  ivec2 at = tile.origin + within + ivec2(tile.below ? tile.side : 0, 0);
  vec3 here = value(at), bend = vec3(0.0);
  for (int i = 0; i < 2; ++i) {
    ivec2 next = ivec2(1 - i, i);
    float inside = within[i] > 0 && within[i] < tile.side - 1 ? 1.0 : 0.0;
    bend += inside * (value(at - next) - 2.0 * here + value(at + next));
  }
  // The first two steps of roughness are uneven.
  for (int i = 0; i < int(tile.level > 2 && tile.level < kProbeLevels - 1); ++i) {
    vec2 units = vec2(within) / float(tile.side - 1);
    float below = tile.below ? 1.0 : 0.0;
    bend += of_level(tile.level - 1, units, below) - 2.0 * here + of_level(tile.level + 1, units, below);
  }
  float most = tile.level == 1 ? 0.06 : 0.25;
  imageStore(map, at, vec4(clamp(here - bend / 12.0, (1.0 - most) * here, (1.0 + most) * here), 1.0));
}
