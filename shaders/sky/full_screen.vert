// One triangle over the whole picture, infinitely far (reversed depth: 0).
#include "shared/frame.h"
layout(location = 0) out vec3 ray;  // toward the pixel, camera-relative, any length

void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(corner, 0.0, 1.0);
  vec4 near = frame.relative_from_clip * vec4(corner, 1.0, 1.0);
  ray = near.xyz / near.w;
}
