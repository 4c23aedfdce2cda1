// The next mip of what the probe sees: means by solid angle, which alpha holds.
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = 0) uniform readonly image2D finer;
layout(rgba32f, binding = 1) uniform writeonly image2D coarser;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(texel, imageSize(coarser)))) return;
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 4; ++i) {
    vec4 part = imageLoad(finer, 2 * texel + ivec2(i & 1, i >> 1));
    sum += part * vec4(part.aaa, 1.0);
  }
  imageStore(coarser, texel, vec4(sum.rgb / sum.a, sum.a));
}
