// The clouds of some of the picture's pixels: one of each cell of CELL_X × CELL_Y, another one every frame.
#include "shared/frame.h"
#include "clouds/march.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f, binding = 0) uniform writeonly image2D seen;   // radiance × exposure, transmittance
layout(r16f, binding = 1) uniform writeonly image2D distance;  // m
layout(location = 0) uniform ivec2 cell;    // pixels
layout(location = 1) uniform ivec2 chosen;  // of the cell
layout(location = 2) uniform int light_steps;
layout(location = 3) uniform int first_row;  // below it there is only sea

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, first_row);
  if (any(greaterThanEqual(texel, imageSize(seen)))) return;
  vec2 pixel = vec2(texel * cell + chosen) + 0.5;
  vec4 near = frame.relative_from_clip * vec4(2.0 * pixel * frame.viewport.zw - 1.0, 1.0, 1.0);
  vec3 direction = normalize(near.xyz / near.w);
  CloudSight sight = cloud_sight(direction, light_steps);
  imageStore(seen, texel, vec4(min(sight.radiance * frame.time.z, vec3(30000.0)), sight.transmittance));
  imageStore(distance, texel, vec4(min(sight.distance, 60000.0)));
}
