// A square round the sun or the moon, infinitely far.
#include "shared/frame.h"
layout(location = 0) uniform vec4 body;  // xyz: toward it, w: sine of its angular radius
layout(location = 3) uniform float reach;  // half the square's side over that radius

void main() {
  vec2 corner = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID >> 1) * 2 - 1);
  vec3 right = normalize(cross(body.xyz, abs(body.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
  vec3 above = cross(right, body.xyz);
  float half_size = reach * body.w + 2.0 * frame.camera.w;
  vec3 d = body.xyz + half_size * (corner.x * right + corner.y * above);
  gl_Position = frame.clip_from_relative * vec4(d, 0.0);
  gl_Position.z = 0.0;
}
