// Level 0 of the probe: what is seen from the boat, texel by texel; and the finest of its mips.
#include "shared/frame.h"
#include "sky/sky.glsl"
#include "sky/probe_source.glsl"
#include "lib/probe.glsl"

layout(local_size_x = 16, local_size_y = 4) in;
layout(rgba16f, binding = 0) uniform writeonly image2D map;
layout(rgba32f, binding = 1) uniform writeonly image2D mip;
layout(location = 0) uniform ivec4 region;  // first texel, texels per side, first row

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, region.w);
  if (texel.x >= 2 * region.z || texel.y >= region.z) return;
  bool below = texel.x >= region.z;
  vec2 units = vec2(texel.x - (below ? region.z : 0), texel.y) / float(region.z - 1);
  vec3 d = probe_direction(units, below ? -1.0 : 1.0);
  // The level itself belongs to both squares; the lower one shows what lies just below the horizon.
  d.y = below ? min(d.y, -sky.observer.y - 1.0e-6) : d.y;
  vec3 light = min(probe_source(normalize(d)), vec3(6.0e4));
  imageStore(map, region.xy + texel, vec4(light, 1.0));
  // The solid angle that a texel stands for; of those on the edges half lies outside.
  float angle = 0.0;
  for (int i = 0; i < 4; ++i) {
    vec2 part = units + (0.5 * vec2(i & 1, i >> 1) - 0.25) / float(region.z - 1);
    bool inside = all(greaterThanEqual(part, vec2(0.0))) && all(lessThanEqual(part, vec2(1.0)));
    angle += inside ? 0.25 * probe_solid_angle(part) : 0.0;
  }
  imageStore(mip, texel, vec4(light, angle / float((region.z - 1) * (region.z - 1))));
}
