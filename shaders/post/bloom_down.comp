// A picture of a quarter (the first) or half the size: the mean of what each texel covers, by four
// bilinear reads between texels.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D source;
layout(rgba16f, binding = 0) uniform writeonly image2D target;
layout(location = 0) uniform vec4 step_and_level;  // xy: from the middle to a read; z: level read
layout(location = 1) uniform ivec2 size;

vec3 read(vec2 at) {
  vec3 c = textureLod(source, at, step_and_level.z).rgb;
  // What is no number must stay the one pixel that it is.
  return any(isnan(c)) || any(isinf(c)) ? vec3(0.0) : c;
}

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(texel, size))) return;
  vec2 at = (vec2(texel) + 0.5) / vec2(size);
  vec2 s = step_and_level.xy;
  vec3 sum = read(at + s) + read(at - s) + read(at + vec2(s.x, -s.y)) + read(at + vec2(-s.x, s.y));
  imageStore(target, texel, vec4(0.25 * sum, 1.0));
}
