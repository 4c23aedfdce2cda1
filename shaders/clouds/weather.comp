// The weather of now: a mixture of patterns that move against each other, so that clouds and fronts come
// and go. A function of the clock alone.
#include "lib/clouds.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D patterns;  // repeating; every channel evenly distributed
layout(binding = 1) uniform sampler2D picture;
layout(rgba8, binding = 0) uniform writeonly image2D weather;
layout(location = 0) uniform vec4 offsets[2];  // of cells, finer cells; fronts, patches
layout(location = 2) uniform vec4 state;       // cover, type, precipitation, 1 where a picture counts
layout(location = 3) uniform vec4 given;       // 1 for each channel that the picture has

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = imageSize(weather);
  if (any(greaterThanEqual(texel, size))) return;
  vec2 at = (vec2(texel) + 0.5) / vec2(size);
  vec4 cells = textureLod(patterns, at + offsets[0].xy, 0.0);
  float finer = textureLod(patterns, 2.0 * at.yx + offsets[0].zw, 0.0).r;
  float rolls = textureLod(patterns, weather_rolls(at) + offsets[0].wz, 0.0).r;
  float fronts = textureLod(patterns, at + offsets[1].xy, 0.0).g;
  vec4 patches = textureLod(patterns, at + offsets[1].zw, 0.0);
  vec4 made;
  made.r = weather_coverage(vec4(cells.r, finer, fronts, rolls), state.x, state.y);
  made.g = clamp(state.y + 0.30 * (patches.a - 0.5) * min(4.0 * state.y * (1.0 - 0.6 * state.y), 1.0), 0.0, 1.0);
  made.b = patches.b;
  made.a = weather_rain(made.r, fronts, patches.a, state.x, state.y, state.z);
  vec4 drawn = textureLod(picture, at, 0.0);
  imageStore(weather, texel, mix(made, drawn, given * state.w));
}
