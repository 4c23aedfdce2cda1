// Reading one region of the probe while another is made from it.
#include "lib/probe.glsl"
#include "shared/bindings.h"

layout(binding = OFFING_UNIT_PROBE) uniform sampler2D map_so_far;
layout(location = 0) uniform ivec4 region;  // to make: first texel, texels per side, first row
layout(location = 1) uniform ivec4 source;  // to read: first texel, texels per side

vec3 read_level(ivec4 level, vec2 units, bool below) {
  vec2 at = vec2(level.xy) + 0.5 + units * float(level.z - 1) + vec2(below ? level.z : 0, 0.0);
  return textureLod(map_so_far, at / vec2(textureSize(map_so_far, 0)), 0.0).rgb;
}

struct ProbeTexel {
  ivec2 place;
  vec2 units;
  bool below;
  bool inside;
};
ProbeTexel this_texel() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, region.w);
  ProbeTexel t;
  t.inside = texel.x < 2 * region.z && texel.y < region.z;
  t.place = region.xy + texel;
  t.below = texel.x >= region.z;
  t.units = vec2(texel.x - (t.below ? region.z : 0), texel.y) / float(region.z - 1);
  return t;
}
