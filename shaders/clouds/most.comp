// How high clouds can reach in and round each coarse cell of the weather: what a march may skip on. As a share
// of the tallest cloud anywhere; 0: no cloud at any height. A ring of one texel more covers the filter between
// texels.
#include "lib/clouds.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D weather;
layout(r8, binding = 0) uniform writeonly image2D most;
layout(location = 0) uniform vec4 form;  // 1 - cover, shift of the edge, strength of the body's noise, tallest cloud (m)

const int kHeights = 32;

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
  CloudKind kind = cloud_kind(value.g, value.a);
  float storm = value.a * value.a * value.g;
  float strength = cloud_strength(kind, value.r - form.x) - form.y;
  float top = 0.0;
  for (int i = 0; i < kHeights; ++i) {
    float x = 1.06 * float(i) / float(kHeights);
    float inside = strength + 0.5 * kind.roughness * form.z * cloud_freedom(x) - cloud_outline(kind, storm, x);
    top = inside > 0.0 ? x + 1.06 / float(kHeights) : top;
  }
  // Rounded up.
  imageStore(most, cell, vec4(top > 0.0 ? min(top * kind.thickness / form.w + 1.0 / 255.0, 1.0) : 0.0));
}
