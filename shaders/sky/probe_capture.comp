// Level 0 of the probe: what is seen from the boat, texel by texel; and the same as nodes of the sums that the
// other levels are (engine/sky/probe_plan.h).
#include "shared/frame.h"
#include "sky/sky.glsl"
#include "sky/probe_source.glsl"
#include "sky/probe_tile.glsl"
#include "lib/probe.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f, binding = 0) uniform writeonly image2D map;
layout(rgba32f, binding = 1) uniform writeonly image2D seen;
layout(binding = 0) uniform sampler2D places;
// 1: the sky's tables as they are, for every roughness: no clouds, no sea. Then levels other than 0 are
// made so too.
layout(location = 5) uniform int plain;

void main() {
  ProbeTile tile = this_tile();
  bool below = tile.below;
  ivec2 texel = tile.corner + ivec2(gl_LocalInvocationID.xy);
  if (any(greaterThanEqual(texel, ivec2(tile.side)))) return;
  vec2 units = vec2(texel) / float(tile.side - 1);
  texel.x += below ? tile.side : 0;
  vec3 d = probe_direction(units, below ? -1.0 : 1.0);
  // The level itself belongs to both squares; the lower one shows what lies just below the horizon.
  d.y = below ? min(d.y, -sky.observer.y - 1.0e-6) : d.y;
  vec3 light = vec3(0.0);
  for (int i = plain; i < 1; ++i) light = probe_source(normalize(d));
  for (int i = 0; i < plain; ++i) light = sky_radiance(d) / max(frame.sky_illuminance.rgb, vec3(1.0e-9));
  light = min(light, vec3(6.0e4));
  imageStore(map, tile.origin + texel, vec4(light, 1.0));
  if (tile.level > 0) return;
  // Between the level and the horizon there is sky, thinner than a texel: in sums it counts. Depth below
  // the level goes with the square of the distance from the square's edge (lib/probe.glsl).
  vec2 edge = 1.0 - max(abs(2.0 * units.x - 1.0), abs(2.0 * units.y - 1.0)) +
              vec2(-1.0, 1.0) / float(tile.side - 1);
  vec2 depth = max(edge, 0.0) * max(edge, 0.0);
  depth *= 2.0 - depth;
  float strip = below ? clamp((sky.observer.y - depth.x) / (depth.y - depth.x), 0.0, 1.0) : 0.0;
  for (int i = 0; i < int(strip > 0.0); ++i) {
    light = mix(light, probe_source(normalize(vec3(d.x, -0.5 * sky.observer.y, d.z))), strip);
  }
  imageStore(seen, texel, vec4(light, texelFetch(places, texel, 0).w));
}
