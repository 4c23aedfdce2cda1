// Making one level of the probe from the mips of what it sees.
#include "lib/probe.glsl"
#include "shared/bindings.h"
#include "shared/probe.h"

layout(binding = OFFING_UNIT_PROBE) uniform sampler2D seen;  // two squares side by side
layout(location = 0) uniform ivec4 region;  // to make: first texel, texels per side, first row

float mip_side() { return float(textureSize(seen, 0).y); }

vec3 read_mip(vec2 units, bool below, float level) {
  float nearest = clamp(floor(level + 0.5), 0.0, float(kProbeMips - 1));
  float side = mip_side(), half_texel = 0.5 * exp2(nearest) / side;
  // Not across the seam between the squares.
  vec2 at = clamp((0.5 + units * (side - 1.0)) / side, half_texel, 1.0 - half_texel);
  return textureLod(seen, vec2(0.5 * (at.x + (below ? 1.0 : 0.0)), at.y), nearest).rgb;
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
