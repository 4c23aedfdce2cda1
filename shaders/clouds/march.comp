// The clouds of some of the picture's pixels: one of each cell of CELL_X × CELL_Y, another one every frame.
#include "shared/frame.h"
#include "clouds/march.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f, binding = 0) uniform writeonly image2D seen;   // radiance × exposure, transmittance
layout(r16f, binding = 1) uniform writeonly image2D distance;  // m
layout(location = 0) uniform ivec2 cell;    // pixels
layout(location = 1) uniform ivec2 chosen;  // of the cell
layout(location = 2) uniform int light_steps;
layout(location = 3) uniform ivec4 part;  // of the cells: the first and how many. Tall ones are gone through upward

void main() {
  ivec2 at = ivec2(part.w > part.z ? gl_GlobalInvocationID.yx : gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(at, part.zw))) return;
  ivec2 texel = part.xy + at;
  vec2 pixel = vec2(texel * cell + chosen) + 0.5;
  vec4 near = frame.relative_from_clip * vec4(2.0 * pixel * frame.viewport.zw - 1.0, 1.0, 1.0);
  vec3 direction = normalize(near.xyz / near.w);
  CloudSight sight = cloud_sight(direction, light_steps);
  imageStore(seen, texel, vec4(min(sight.radiance * frame.time.z, vec3(30000.0)), sight.transmittance));
  imageStore(distance, texel, vec4(min(sight.distance, 60000.0)));
}
