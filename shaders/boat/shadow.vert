// Rigid parts as the light sees them.
#include "shared/boat.h"
#include "shared/boat_shadow.h"

layout(location = 0) in vec3 position;
layout(location = 0) uniform int node;

void main() {
  vec4 relative = boat.relative_from_boat * (boat.boat_from_node[node] * vec4(position, 1.0));
  vec4 place = boat_shadow.map_from_relative * relative;
  gl_Position = vec4(2.0 * place.xy - 1.0, place.zw);
}
