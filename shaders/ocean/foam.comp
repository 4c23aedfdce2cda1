// One step of the foam map: what there was fades, what breaks now comes to it. See foam_map.h.
#include "shared/ocean.h"
#include "lib/water.glsl"
#include "ocean/surface.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 2) uniform sampler2D foam_pattern;
layout(binding = 0, rg16f) uniform image2DArray map;  // thin foam, thick foam
layout(std140, binding = OFFING_BIND_FOAM) uniform FoamBlock { FoamData foam; };

// Rows of foam along the wind, where water that turns over under it sinks (Langmuir 1938): -1 … 1, with
// distances of some 15 m that wander.
float rows(vec2 q) {
  // In the foam texture's own place, which is fixed to the world.
  vec2 at = ocean.foam_grid.xy + vec2(dot(ocean.foam_grid.zw, q),
            ocean.foam_stretch.x * (ocean.foam_grid.z * q.y - ocean.foam_grid.w * q.x));
  float wide = textureLod(foam_pattern, at * vec2(0.125, 0.5), 3.0).r;
  float fine = textureLod(foam_pattern, at * vec2(0.25, 1.0) + 0.37, 2.0).r;
  return clamp(0.7 * (wide + fine), -1.0, 1.0);
}

void main() {
  int layer = int(gl_GlobalInvocationID.z);
  ivec2 texel = ivec2(gl_GlobalInvocationID.x,
                      int(foam.step.y) + int(gl_GlobalInvocationID.y) * int(foam.step.z));
  // Cells from the camera's, -SIZE/2 … SIZE/2 - 1.
  ivec2 away = ((texel - ivec2(foam.place[layer].xy) + SIZE / 2 + SIZE) & (SIZE - 1)) - SIZE / 2;
  float size = foam.cell[layer].x;
  vec2 q = foam.cell[layer].zw + (vec2(away) + 0.5) * size;

  vec3 squeeze = vec3(0.0);  // Dxx, Dzz, Dxz
  int breaking = int(ocean.foam.z);
  for (int c = 0; c < breaking; ++c) {
    float level = sea_map_level(c, size);
    float share = sea_map_share(level);
    if (share <= 0.0) break;
    vec3 place = sea_map_place(c, q);
    squeeze += share * vec3(textureLod(sea_slopes, place, level).zw,
                            textureLod(sea_displacement, place, level).w);
  }
  float jacobian = surface_jacobian(squeeze.x, squeeze.y, squeeze.z);
  // What is too fine for the cell is the part of the Jacobian's distribution below the edge.
  float unresolved = sea_unresolved(size);
  float spread = sqrt(ocean.foam_share.z * unresolved + ocean.foam.w);
  float fresh = normal_below((ocean.foam.x - jacobian) / spread);

  vec2 was = imageLoad(map, ivec3(texel, layer)).xy;
  ivec2 before = away + ivec2(foam.place[layer].zw);
  bool seen_before = all(greaterThanEqual(before, ivec2(-SIZE / 2))) &&
                     all(lessThan(before, ivec2(SIZE / 2)));
  float at_start = normal_below((ocean.foam.y - jacobian) / spread);
  // Rows keep their foam for longer and take it from between.
  float lasts = THIN_SECONDS * (1.0 + ocean.foam_share.w * 0.8 * rows(q));
  float thick = max(was.y * exp(-foam.step.x / FRESH_SECONDS), fresh);
  // What breaks leaves thin foam at a steady rate, and that fades. Being linear this has the same mean
  // whether a cell is narrower than the waves or wider, and at any frame rate.
  float thin = min(mix(fresh * ocean.foam_share.y, was.x, exp(-foam.step.x / lasts)), 1.0);
  vec2 now = seen_before ? vec2(thin, thick) : vec2(at_start, fresh);
  imageStore(map, ivec3(texel, layer), vec4(now, 0.0, 0.0));
}
