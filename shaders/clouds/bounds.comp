// What the neighbourhood of each marched pixel holds: a history outside of it is out of date.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D seen;
layout(rgba16f, binding = 0) uniform writeonly image2D least;
layout(rgba16f, binding = 1) uniform writeonly image2D most;
layout(location = 0) uniform int first_row;  // those before it hold nothing

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, first_row);
  ivec2 size = imageSize(least);
  if (any(greaterThanEqual(texel, size))) return;
  vec4 low = vec4(1.0e9), high = vec4(-1.0e9);
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i) {
      vec4 value = texelFetch(seen, clamp(texel + ivec2(i, j), ivec2(0, first_row), size - 1), 0);
      low = min(low, value);
      high = max(high, value);
    }
  }
  imageStore(least, texel, low);
  imageStore(most, texel, high);
}
