// The closed hull, to tell where no water may be seen.
#include "shared/frame.h"
#include "shared/boat.h"

layout(location = 0) in vec3 position;
layout(location = 3) in vec2 ids;  // node, material

out vec3 relative_position;

void main() {
  vec4 relative = boat.relative_from_boat * (boat.boat_from_node[int(ids.x)] * vec4(position, 1.0));
  relative_position = relative.xyz;
  gl_Position = frame.clip_from_relative * relative;
}
