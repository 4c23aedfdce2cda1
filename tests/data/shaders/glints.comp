// The factor of the glitter for patches side by side.
#include "shared/frame.h"
#include "shared/ocean.h"
#include "ocean/surface.glsl"
#include "ocean/glints.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = 1) writeonly buffer Factors { float factors[]; };
layout(location = 0) uniform vec4 patch_;  // size (m), density, time (s)

void main() {
  uint i = gl_GlobalInvocationID.x;
  vec2 q = (vec2(i & 255u, i >> 8) - 127.5) * patch_.x;
  factors[i] = glint(q, patch_.x, patch_.y, patch_.z);
}
