// Brings the probe that is shown nearer to the one last finished: by 1/n, 1/(n-1) … 1 of what is left in
// n frames, which is an even pace that ends exactly there.
#include "shared/probe.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f, binding = 0) uniform image2D shown;
layout(rgba16f, binding = 1) uniform readonly image2D finished;
layout(std430, binding = 0) buffer Shown { ProbeData shown_data; };
layout(std430, binding = 1) readonly buffer Finished { vec4 finished_irradiance[kProbeHarmonics]; };
layout(location = 0) uniform float share;
layout(location = 1) uniform ivec2 size;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (all(lessThan(texel, size))) {
    vec4 goal = imageLoad(finished, texel);
    // Not even read where it is not wanted: it may hold anything before the first frame.
    vec4 old = share < 1.0 ? imageLoad(shown, texel) : goal;
    imageStore(shown, texel, mix(old, goal, share));
  }
  if (texel.y == 0 && texel.x < kProbeHarmonics) {
    vec4 goal = finished_irradiance[texel.x];
    vec4 old = share < 1.0 ? shown_data.irradiance[texel.x] : goal;
    shown_data.irradiance[texel.x] = mix(old, goal, share);
  }
}
