// The clouds all round as the water and the boat see them: some rows of a hemi-octahedral map, radiance in
// cd/m^2 with the air before it, and what shows of the sky behind.
#include "shared/frame.h"
#include "clouds/march.glsl"
#include "lib/cloud_map.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f, binding = 0) uniform writeonly image2D map;
layout(location = 0) uniform ivec2 rows;  // first and number
layout(location = 1) uniform int light_steps;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, rows.x);
  int size = imageSize(map).x;
  if (texel.x >= size || texel.y >= min(rows.x + rows.y, size)) return;
  vec3 direction = cloud_map_direction((vec2(texel) + 0.5) / float(size));
  CloudSight sight = cloud_sight(direction, light_steps);
  imageStore(map, texel, vec4(min(sight.radiance, vec3(6.0e4)), sight.transmittance));
}
