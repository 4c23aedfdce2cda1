// The most that the weather holds in and round each coarse cell: what a march may skip on. R: coverage,
// G: type, B: the lowest base, A: rain. A ring of one texel more covers the filter between texels.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D weather;
layout(rgba8, binding = 0) uniform writeonly image2D most;

void main() {
  ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
  ivec2 cells = imageSize(most);
  if (any(greaterThanEqual(cell, cells))) return;
  int size = textureSize(weather, 0).x;
  int side = size / cells.x;
  vec4 value = vec4(0.0, 0.0, 1.0, 0.0);
  for (int j = -1; j <= side; ++j) {
    for (int i = -1; i <= side; ++i) {
      vec4 w = texelFetch(weather, (cell * side + ivec2(i, j) + size) % size, 0);
      value = vec4(max(value.rg, w.rg), min(value.b, w.b), max(value.a, w.a));
    }
  }
  imageStore(most, cell, value);
}
