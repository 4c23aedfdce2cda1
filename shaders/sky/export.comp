// The sky over a latitude-longitude picture: row 0 the zenith, column 0 north, eastward.
#include "shared/frame.h"
#include "sky/sky.glsl"
#include "sky/probe_source.glsl"

layout(local_size_x = 16, local_size_y = 4) in;
layout(std430, binding = 0) writeonly buffer Picture { vec4 picture[]; };
layout(location = 0) uniform ivec2 size;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(texel, size))) return;
  vec2 angle = (vec2(texel) + 0.5) / vec2(size) * vec2(2.0, 1.0) * kPhasePi;
  vec3 d = vec3(sin(angle.x) * sin(angle.y), cos(angle.y), -cos(angle.x) * sin(angle.y));
  picture[texel.y * size.x + texel.x] = vec4(sky_clouds_and_sea(d), 1.0);
}
