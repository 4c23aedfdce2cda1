// A picture of a quarter (the first) or half the size. A tent over twice a texel's width, of sixteen bilinear
// reads: a box would show as a square about a small bright thing.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D source;
layout(rgba16f, binding = 0) uniform writeonly image2D target;
layout(location = 0) uniform vec4 step_and_level;  // xy: half of the way between two reads; z: level read
layout(location = 1) uniform ivec2 size;

vec3 read(vec2 at, int x, int y) {
  vec3 c = textureLod(source, at + step_and_level.xy * vec2(2 * x - 3, 2 * y - 3), step_and_level.z).rgb;
  // What is no number must stay the one pixel that it is.
  return c.r + c.g + c.b < 1.0e30 ? c : vec3(0.0);
}

float share(int x, int y) { return (abs(2 * x - 3) == 1 ? 0.375 : 0.125) * (abs(2 * y - 3) == 1 ? 0.375 : 0.125); }

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(texel, size))) return;
  vec2 at = (vec2(texel) + 0.5) / vec2(size);
  vec3 sum = vec3(0.0);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) sum += share(x, y) * read(at, x, y);
  }
  imageStore(target, texel, vec4(sum, 1.0));
}
