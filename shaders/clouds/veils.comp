// What hangs in the air between the sea and the clouds, at a fraction of the picture's size: shafts of light
// and shadow, and rain. Stored are the rain's radiance × exposure and the share of everything behind
// that is left.
#include "shared/frame.h"
#include "sky/sky.glsl"
#include "clouds/density.glsl"
#include "clouds/shadow.glsl"
#include "clouds/air.glsl"
#include "lib/rain.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f, binding = 0) uniform writeonly image2D veils;
layout(location = 0) uniform int cell;
layout(location = 1) uniform vec4 amount;  // shafts; heaviest rain (mm/h); lag of drops over the sea (m)
layout(location = 2) uniform ivec2 steps;  // along shafts, through rain

const float kShaftReach = 45000.0;  // m
const float kRainReach = 45000.0;

#include "clouds/shafts.glsl"
#include "clouds/rain.glsl"

// Interleaved gradient noise (Jimenez 2014).
float spread_noise(vec2 pixel) {
  return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
}

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(texel, imageSize(veils)))) return;
  vec2 pixel = (vec2(texel) + 0.5) * float(cell);
  vec4 way = frame.relative_from_clip * vec4(2.0 * pixel * frame.viewport.zw - 1.0, 1.0, 1.0);
  vec3 direction = normalize(way.xyz / way.w);
  float jitter = spread_noise(vec2(texel));
  // From the sea up to the bases.
  CloudSpan span = cloud_shell(max(clouds.eye.x, 1.0), direction.y, clouds.eye.y, 0.0, clouds.layer.w);
  float missing = 0.0;
  // Loops that run once or not at all: a CPU renderer runs both sides of an if.
  bool any = span.far > span.near;
  for (int i = 0; i < int(any && steps.x > 0); ++i) missing = shaft_missing(direction, span, jitter);
  RainVeil rain;
  rain.light = vec3(0.0);
  rain.transmittance = 1.0;
  for (int i = 0; i < int(any && steps.y > 0); ++i) rain = rain_veil(direction, span, jitter);
  vec3 light = min(rain.light * frame.time.z, vec3(30000.0));
  imageStore(veils, texel, vec4(light, rain.transmittance * (1.0 - missing)));
}
