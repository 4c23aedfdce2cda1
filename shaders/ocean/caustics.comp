// Light gathered by the waves: rays of sun or moon from a grid of points of water at rest, bent by the
// slope there, each laid over the texels about where it crosses every layer's depth, as a square as wide as
// rays lie apart in level water: half a texel. Texels on the surface, back along the level sea's ray. Whole numbers, so that the order of the sums does not
// matter and no light is lost.
#include "shared/frame.h"
#include "shared/ocean.h"
#include "lib/phase.glsl"
#include "lib/water.glsl"
#include "lib/underwater.glsl"
#include "shared/bindings.h"
#include "shared/underwater.h"
#include "ocean/surface.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 0) buffer Gathered { uint gathered[]; };  // by layer, row and column

const float kUnit = 4096.0;

void main() {
  ivec2 index = ivec2(gl_GlobalInvocationID.xy);
  int row = int(water.photons.w), texels = int(water.caustics.w);
  if (index.x >= row || index.y >= row) return;
  vec2 q = water.photons.xy + water.photons.z * vec2(index);
  vec4 slopes = vec4(0.0), displacement = vec4(0.0);
  int cascades = int(ocean.water.y);
  for (int c = 0; c < cascades; ++c) {
    float level = sea_map_level(c, water.photons.z);
    float share = sea_map_share(level);
    if (share <= 0.0) break;
    vec3 place = sea_map_place(c, q);
    slopes += share * textureLod(sea_slopes, place, level);
    displacement += share * textureLod(sea_displacement, place, level);
  }
  vec2 slope = surface_slope(slopes.x, slopes.y, slopes.z, slopes.w, displacement.w);
  float jacobian = surface_jacobian(slopes.z, slopes.w, displacement.w);
  Photon ray = photon(water.above.xyz, slope, jacobian);
  float per_texel = water.photons.z * float(texels) / water.caustics.z;
  float carried = ray.carried * per_texel * per_texel * kUnit;
  vec2 back = water.light.xz / water.light.y;

  float depth = kCausticFirst;
  for (int layer = 0; layer < kCausticLayers; ++layer) {
    vec2 at = q + displacement.xz + ray.way * (displacement.y + depth) + back * depth -
              water.caustics.xy;
    vec2 place = (at / water.caustics.z + 0.5) * float(texels) - 0.5;
    ivec2 first = ivec2(floor(place));
    vec2 inside = clamp(2.0 * (place - vec2(first)) - 0.5, 0.0, 1.0);
    for (int corner = 0; corner < 4; ++corner) {
      ivec2 offset = ivec2(corner & 1, corner >> 1);
      ivec2 texel = first + offset;
      vec2 share = mix(vec2(1.0) - inside, inside, vec2(offset));
      bool kept = all(greaterThanEqual(texel, ivec2(0))) && all(lessThan(texel, ivec2(texels)));
      if (kept) {
        atomicAdd(gathered[(layer * texels + texel.y) * texels + texel.x],
                  uint(carried * share.x * share.y + 0.5));
      }
    }
    depth *= kCausticRatio;
  }
}
