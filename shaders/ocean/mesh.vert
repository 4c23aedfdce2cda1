// The sea's mesh: squares of a grid fixed to the world, displaced by all cascades, bent down to the
// horizon. Details finer than the mesh are averaged away before they are sampled.
#include "shared/frame.h"
#include "shared/ocean.h"
#include "ocean/surface.glsl"

layout(location = 0) in vec2 corner;  // 0 … cells
layout(location = 1) in vec4 square;  // x, z relative to the camera; spacing; where morphing ends

out vec3 relative;
out vec2 parameter;  // the point of water at rest, relative to the camera

void main() {
  float eye_height = frame.camera.y;
  vec2 q = square.xy + square.z * corner;
  float distance = length(vec3(q, eye_height));
  float morph = clamp((distance / square.w - MORPH) / (1.0 - MORPH), 0.0, 1.0);
  q -= square.z * morph * mod(corner, vec2(2.0));
  distance = length(vec3(q, eye_height));

  vec3 displacement = vec3(0.0);
  float spacing = max(ocean.water.w, distance / ocean.water.z);
  int cascades = int(ocean.water.y);
  for (int c = 0; c < cascades; ++c) {
    float level = sea_map_level(c, spacing);
    float share = sea_map_share(level);
    if (share <= 0.0) break;  // the cascades that follow are finer still
    displacement += share * textureLod(sea_displacement, sea_map_place(c, q), level).xyz;
  }
  parameter = q;
  relative = vec3(q.x, -eye_height - dot(q, q) / kTwiceEarthRadius, q.y) + displacement;
  gl_Position = frame.clip_from_relative * vec4(relative, 1.0);
}
