// The gathered light as a picture: the mean over a texel and its neighbours (1 2 1), which takes off the
// grain of the rays and about what the sun's width does.
#include "shared/bindings.h"
#include "shared/underwater.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 0) readonly buffer Gathered { uint gathered[]; };
layout(binding = 0) uniform writeonly image2DArray caustics;

void main() {
  ivec3 at = ivec3(gl_GlobalInvocationID);
  int texels = int(water.caustics.w);
  if (at.x >= texels || at.y >= texels) return;
  float sum = 0.0;
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i) {
      ivec2 near = clamp(at.xy + ivec2(i, j), ivec2(0), ivec2(texels - 1));
      float weight = float((2 - abs(i)) * (2 - abs(j))) / 16.0;
      sum += weight * float(gathered[(at.z * texels + near.y) * texels + near.x]);
    }
  }
  imageStore(caustics, at, vec4(sum / 4096.0));
}
