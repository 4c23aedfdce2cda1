// The mean of 3 × 3: neighbours of interleaved gradient noise have taken their samples at evenly spread
// places, so this stands for nine times as many.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D rough;
layout(rgba16f, binding = 0) uniform writeonly image2D smoothed;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 last = imageSize(smoothed) - 1;
  if (any(greaterThan(texel, last))) return;
  vec4 sum = vec4(0.0);
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      sum += texelFetch(rough, clamp(texel + ivec2(x, y), ivec2(0), last), 0);
    }
  }
  imageStore(smoothed, texel, sum / 9.0);
}
