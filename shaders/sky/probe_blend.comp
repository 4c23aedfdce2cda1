// Brings the probe that is shown nearer to the one last finished: by 1/n, 1/(n-1) … 1 of what is left in
// n turns, which is an even pace that ends exactly there. Tiles have fewer turns than the irradiance.
#include "sky/probe_tile.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f, binding = 0) uniform image2D shown;
layout(rgba16f, binding = 1) uniform readonly image2D finished;
layout(std430, binding = 0) buffer Shown { ProbeData shown_data; };
layout(std430, binding = 2) readonly buffer Finished { vec4 finished_irradiance[kProbeHarmonics]; };
layout(location = 1) uniform vec2 shares;  // of what is left: of the tiles; of the irradiance

void main() {
  ProbeTile tile = this_tile();
  ivec2 texel = tile.corner + ivec2(gl_LocalInvocationID.xy);
  if (all(lessThan(texel, ivec2(tile.side)))) {
    texel += tile.origin + ivec2(tile.below ? tile.side : 0, 0);
    vec4 goal = imageLoad(finished, texel);
    // Not even read where it is not wanted: it may hold anything before the first frame.
    vec4 old = shares.x < 1.0 ? imageLoad(shown, texel) : goal;
    imageStore(shown, texel, mix(old, goal, shares.x));
  }
  uint k = gl_LocalInvocationIndex;
  if (gl_WorkGroupID.x == 0u && k < uint(kProbeHarmonics)) {
    vec4 goal = finished_irradiance[k];
    vec4 old = shares.y < 1.0 ? shown_data.irradiance[k] : goal;
    shown_data.irradiance[k] = mix(old, goal, shares.y);
  }
}
