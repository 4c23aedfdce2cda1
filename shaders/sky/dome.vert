// Half the sky as seen from here: a fan of triangles from the zenith down to the sea's horizon, or from
// the nadir up to it, infinitely far (reversed depth: 0). So only pixels that show it are shaded.
#include "shared/frame.h"
#include "shared/bindings.h"
#include "shared/sky.h"
layout(location = 0) uniform float pole;  // 1: sky, -1: sea

const int kSegments = 96;

void main() {
  int corner = gl_VertexID % 3;
  float azimuth = 6.28318531 * float(gl_VertexID / 3 + max(corner - 1, 0)) / float(kSegments);
  // A pixel beyond the horizon, where both halves blend.
  float level = -sky.observer.y - pole * frame.camera.w;
  vec3 rim = normalize(vec3(sin(azimuth), level, -cos(azimuth)));
  gl_Position = frame.clip_from_relative * vec4(corner == 0 ? vec3(0.0, pole, 0.0) : rim, 0.0);
  gl_Position.z = 0.0;
}
