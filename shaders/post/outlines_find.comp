// Which pixels may have stairs: on solid things and beside them, and where sea meets sky. Water glitters in
// single pixels, which are no stairs.
#include "post/outlines.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D shown;
layout(binding = 1) uniform sampler2D solid;  // depth of solid things alone; 0 where there is nothing
layout(binding = 2) uniform sampler2D depth;  // of all

float least(vec4 v) { return min(min(v.x, v.y), min(v.z, v.w)); }
float most(vec4 v) { return max(max(v.x, v.y), max(v.z, v.w)); }

bool may_have_stairs(ivec2 at) {
  // Two squares of four that share this pixel.
  vec2 size = vec2(textureSize(solid, 0));
  vec2 low = vec2(at) / size, high = vec2(at + 1) / size;
  if (textureGather(solid, low) + textureGather(solid, high) != vec4(0.0)) return true;
  vec4 a = textureGather(depth, low), b = textureGather(depth, high);
  return most(max(a, b)) > 0.0 && least(min(a, b)) == 0.0;
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  ivec2 last = textureSize(shown, 0) - 1;
  if (any(greaterThan(at, last)) || !may_have_stairs(at)) return;
  float here = brightness(texelFetch(shown, at, 0).rgb);
  vec4 around = vec4(brightness(texelFetch(shown, ivec2(max(at.x - 1, 0), at.y), 0).rgb),
                     brightness(texelFetch(shown, ivec2(min(at.x + 1, last.x), at.y), 0).rgb),
                     brightness(texelFetch(shown, ivec2(at.x, max(at.y - 1, 0)), 0).rgb),
                     brightness(texelFetch(shown, ivec2(at.x, min(at.y + 1, last.y)), 0).rgb));
  if (max(most(around), here) - min(least(around), here) < kContrast) return;

  uint index = atomicAdd(outlines.count, 1u);
  if (index >= uint(outlines.pixels.length())) return;
  atomicMax(outlines.groups, index / 64u + 1u);
  outlines.pixels[index].x = uint(at.x) | uint(at.y) << 16;
}
