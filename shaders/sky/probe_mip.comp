// Nodes of twice the size (engine/sky/probe_plan.h): means of four by solid angle, which alpha holds.
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = 1) uniform image2D seen;
layout(location = 0) uniform ivec4 region;  // x, y: rows of the finer and the coarser; z, w: size to make

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(texel, region.zw))) return;
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 4; ++i) {
    vec4 part = imageLoad(seen, 2 * texel + ivec2(i & 1, region.x + (i >> 1)));
    sum += part * vec4(part.aaa, 1.0);
  }
  imageStore(seen, texel + ivec2(0, region.y), vec4(sum.rgb / sum.a, sum.a));
}
