// The gathered light as a picture: spread by what the rays do not know, slopes of waves too short for
// them and the sun's width.
#include "shared/ocean.h"
#include "lib/water.glsl"
#include "shared/bindings.h"
#include "shared/underwater.h"
#include "ocean/surface.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 0) readonly buffer Gathered { uint gathered[]; };
layout(binding = 0) uniform writeonly image2DArray caustics;

const float kSunSpread = 2.3e-3;  // rad: standard deviation of an even disc of .266°

// Weights of the texels about one for normal distributions of these variances, square texels.
vec2 weight(int i, vec2 variance) { return exp(-0.5 * float(i * i) / max(variance, vec2(1.0e-3))); }

void main() {
  ivec3 at = ivec3(gl_GlobalInvocationID);
  int texels = int(water.caustics.w);
  if (at.x >= texels || at.y >= texels) return;
  // How far a ray is turned by a slope: n sin = sin, differentiated.
  float below = water.light.y, turn = 1.0 - water.above.y / (kWaterIndex * below);
  float way = kCausticFirst * pow(kCausticRatio, float(at.z)) / (below * below) * float(texels) / water.caustics.z;
  vec2 variance = way * way * (turn * turn * max(sea_missing(log2(water.photons.z)).xy, vec2(0.0)) +
                               kSunSpread * kSunSpread / (kWaterIndex * kWaterIndex));
  int reach = at.z < kCausticLayers - 1 ? 2 : 4;  // texels: it spreads most where it is deepest
  float sum = 0.0;
  vec2 all = vec2(0.0);
  for (int i = -reach; i <= reach; ++i) all += weight(i, variance);
  for (int j = -reach; j <= reach; ++j) {
    for (int i = -reach; i <= reach; ++i) {
      ivec2 near = clamp(at.xy + ivec2(i, j), ivec2(0), ivec2(texels - 1));
      float share = weight(i, variance).x * weight(j, variance).y / (all.x * all.y);
      sum += share * float(gathered[(at.z * texels + near.y) * texels + near.x]);
    }
  }
  imageStore(caustics, at, vec4(sum / 4096.0));
}
