// One of Gardner's ellipsoids as the square that it fills on screen.
#include "shared/frame.h"

layout(location = 0) in vec4 centre;  // xyz relative to the camera (m); w: brightness's share from above
layout(location = 1) in vec4 radii;   // xyz: half axes (m); w: height of its cloud's base over the sea

out Ellipsoid {
  vec3 direction;
  flat vec3 centre;
  flat vec4 radii;
} ellipsoid;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  vec3 toward = normalize(centre.xyz);
  vec3 right = normalize(vec3(-toward.z, 1.0e-6, toward.x));
  vec3 up = cross(right, toward);
  float reach = max(max(radii.x, radii.y), radii.z);
  float distance = length(centre.xyz);
  // Of a sphere seen from this near, the outline is wider than its middle's cut.
  float wide = reach / sqrt(max(1.0 - reach * reach / (distance * distance), 0.04));
  vec3 p = centre.xyz + (right * corner.x + up * corner.y) * wide;
  ellipsoid.direction = p;
  ellipsoid.centre = centre.xyz;
  ellipsoid.radii = radii;
  gl_Position = frame.clip_from_relative * vec4(p, 1.0);
}
