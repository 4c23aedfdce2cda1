// What the picture of the sea shows at random places: foam, and the slopes that pixels resolve and do not.
#include "shared/frame.h"
#include "shared/ocean.h"
#include "lib/water.glsl"
#include "ocean/surface.glsl"
float die = 0.0;
float sea_die() { return die; }  // as in ocean/die.glsl, where there are pixels
#include "ocean/ripples.glsl"
#include "ocean/resolved.glsl"
#include "ocean/foam.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Places { vec4 places[]; };  // x, z, die, size (m)
layout(std430, binding = 1) writeonly buffer Seen { vec4 seen[]; };     // cover, opacity; slope², missing

void main() {
  vec4 place = places[gl_GlobalInvocationID.x];
  die = place.z;
  Surface surface = read_surface(place.xy, place.w, 1.0);
  Foam foam = sea_foam(place.xy, place.w, surface.jacobian, surface.unresolved);
  seen[gl_GlobalInvocationID.x] = vec4(foam.cover, foam.opacity, dot(surface.slope, surface.slope),
                                       surface.covariance.x + surface.covariance.y);
}
