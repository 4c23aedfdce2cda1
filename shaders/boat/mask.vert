// The closed hull, to tell where no water may be seen.
#include "shared/frame.h"
#include "shared/boat.h"

layout(location = 0) in vec3 position;  // boat frame

out vec3 relative_position;

void main() {
  vec4 relative = boat.relative_from_boat * vec4(position, 1.0);
  relative_position = relative.xyz;
  gl_Position = frame.clip_from_relative * relative;
}
