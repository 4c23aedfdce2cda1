// How high clouds can reach in and round each coarse cell of the weather: what a march may skip on. As a share
// of the tallest cloud anywhere; 0: no cloud at any height. A ring of one texel more covers the filter between
// texels.
#include "lib/clouds.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D weather;
layout(r8, binding = 0) uniform writeonly image2D most;
layout(location = 0) uniform vec4 form;  // weather_threshold(), shift of the edge, strength of the body's noise, tallest cloud (m)
layout(location = 1) uniform vec2 storms;  // their thickness (m; 0: none), the rain in their middle

const int kHeights = 32;
const float kOver = 1.06;  // of a kind's thickness: no noise lifts it higher

void main() {
  ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
  ivec2 cells = imageSize(most);
  if (any(greaterThanEqual(cell, cells))) return;
  int size = textureSize(weather, 0).x;
  int side = size / cells.x;
  vec4 value = vec4(0.0);
  for (int j = -1; j <= side; ++j) {
    for (int i = -1; i <= side; ++i)
      value = max(value, texelFetch(weather, (cell * side + ivec2(i, j) + size) % size, 0));
  }
  CloudKind kind = cloud_kind(value.g);
  CloudKind storm = storm_kind(storms.x, storms.y);
  float strength = cloud_strength(kind, value.r - form.x);
  float top = 0.0;  // m
  for (int i = 0; i < kHeights; ++i) {
    float x = kOver * float(i) / float(kHeights), next = kOver * float(i + 1) / float(kHeights);
    float most = strength + 0.5 * form.z * cloud_reach(kind, x);
    float inside = kind.sharpness * (most - cloud_outline(kind, x)) + kind.given;
    if (inside > form.y) top = max(top, next * kind.thickness);
    float free = form.z * cloud_freedom(5.0 * x);
    most = storm_strength(storm, value.a, 1.0, free) + 0.5 * storm.roughness * free;
    bool stands = storms.x > 0.0 && value.a > 0.0;
    if (stands && storm.sharpness * (most - storm_outline(storm, x)) > form.y) top = max(top, next * storms.x);
  }
  // Rounded up.
  imageStore(most, cell, vec4(top > 0.0 ? min(top / (kOver * form.w) + 1.0 / 255.0, 1.0) : 0.0));
}
