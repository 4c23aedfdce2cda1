// Which pixels look into the air and which into the water: the lens may be half in, half out. A pixel's
// ray begins at the near side of the view; where that point lies below the waves it is wet.
#include "shared/frame.h"
#include "shared/ocean.h"
#include "ocean/surface.glsl"

layout(binding = 3) uniform sampler2D sea_seen;  // see mesh.frag; the size is negative from below
layout(binding = 4) uniform sampler2D solid;     // depth of what was drawn before the sea
layout(location = 0) out vec4 above;             // of dry pixels: as mesh.frag has it
layout(location = 1) out vec4 below;  // of wet ones: the same, with distance -1 where there is no surface
layout(location = 2) out float beyond;  // of the near side: height above the water, m

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 seen = texelFetch(sea_seen, pixel, 0);
  vec4 way = frame.relative_from_clip *
             vec4(2.0 * gl_FragCoord.xy * frame.viewport.zw - 1.0, 1.0, 1.0);
  vec3 near = way.xyz / way.w;
  // The water at that place, by fixed-point steps back from where the displaced surface is (they
  // converge since the surface hardly folds), as finely as the mesh has it.
  vec2 q = near.xz;
  vec3 displacement = vec3(0.0);
  int cascades = int(ocean.water.y);
  for (int i = 0; i < 4; ++i) {
    displacement = vec3(0.0);
    for (int c = 0; c < cascades; ++c) {
      float level = sea_map_level(c, ocean.water.w);
      float share = sea_map_share(level);
      if (share <= 0.0) break;
      displacement += share * textureLod(sea_displacement, sea_map_place(c, q), level).xyz;
    }
    q = near.xz - displacement.xz;
  }
  beyond = frame.camera.y + near.y - displacement.y;

  // What the mesh shows must agree, and its triangles lie a little off the maps: within that, the side
  // of the surface that is seen decides, or the look up or down where there is none.
  float doubt = 0.1 * ocean.water.w + 0.02 * ocean.water.x;
  float hint = 0.0;
  if (seen.w > 0.0) {
    hint = seen.z > 0.0 ? doubt : -doubt;
  } else if (texelFetch(solid, pixel, 0).r <= 0.0) {
    hint = doubt * clamp(50.0 * near.y / length(near), -1.0, 1.0);
  }
  bool wet = beyond + hint < 0.0;
  above = wet ? vec4(0.0) : vec4(seen.xy, abs(seen.z), seen.w);
  below = wet ? vec4(seen.xy, abs(seen.z), seen.w > 0.0 ? seen.w : -1.0) : vec4(0.0);
}
