// Each level takes in the one below it, a tent wide: all levels together are a glow with a sharp middle
// and long skirts (Jimenez, "Next generation post processing in Call of Duty", 2014). Shares add up to
// 1: light is spread, not made.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D smaller;
layout(rgba16f, binding = 0) uniform image2D target;
layout(location = 0) uniform vec4 step_and_level;
layout(location = 1) uniform ivec2 size;
layout(location = 2) uniform float share;  // of the smaller levels

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(texel, size))) return;
  vec2 at = (vec2(texel) + 0.5) / vec2(size);
  vec2 s = step_and_level.xy;
  float level = step_and_level.z;
  vec3 sum = textureLod(smaller, at + s, level).rgb + textureLod(smaller, at - s, level).rgb +
             textureLod(smaller, at + vec2(s.x, -s.y), level).rgb +
             textureLod(smaller, at + vec2(-s.x, s.y), level).rgb;
  imageStore(target, texel, vec4(mix(imageLoad(target, texel).rgb, 0.25 * sum, share), 1.0));
}
