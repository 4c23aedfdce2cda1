// A flow without sources in the plane: two octaves of tiled_curl(), within -1 … 1.
#include "lib/noise.glsl"
#include "lib/cloud_noise.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rg8_snorm, binding = 0) uniform writeonly image2D curl;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  int size = imageSize(curl).x;
  if (any(greaterThanEqual(texel, ivec2(size)))) return;
  vec2 at = (vec2(texel) + 0.5) / float(size);
  vec2 flow = tiled_curl(at, 6, size, 3) + 0.5 * tiled_curl(at, 14, size, 4);
  imageStore(curl, texel, vec4(clamp(0.4 * flow, vec2(-1.0), vec2(1.0)), 0.0, 0.0));
}
