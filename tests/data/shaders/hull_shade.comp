// What the water's glow keeps beside a wall that shades all of x < 0.
#include "shared/frame.h"
#include "shared/ocean.h"
#include "lib/water.glsl"
#include "ocean/surface.glsl"
float die = 0.0;
float sea_die() { return die; }  // as in ocean/die.glsl, where there are pixels
float boat_shade(vec3 relative) { return relative.x < 0.0 ? 0.0 : 1.0; }
bool boat_shadow_misses(vec3 from, vec3 to) { return min(from.x, to.x) >= 0.0; }
#include "ocean/hull_shade.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = 1) writeonly buffer Kept { vec4 kept[]; };  // mean of this place's dice
layout(location = 0) uniform vec4 view;   // from the water; w: first place (m)
layout(location = 1) uniform vec4 light;  // toward it; w: metres between places

void main() {
  const int kDice = 256;
  uint i = gl_GlobalInvocationID.x;
  vec3 sum = vec3(0.0);
  for (int k = 0; k < kDice; ++k) {
    die = (float(k) + 0.5) / float(kDice);
    sum += hull_shade_below(vec3(view.w + light.w * float(i), 0.0, 0.0), view.xyz, light.xyz);
  }
  kept[i] = vec4(sum / float(kDice), 0.0);
}
