// HDR picture to display: glow, night sight, exposure, curve, sRGB, dither. One pass.
#include "lib/colour.glsl"
#include "lib/tonemap.glsl"
#include "post/exposure.glsl"

layout(binding = 0) uniform sampler2D hdr;
layout(binding = 1) uniform sampler2D glow;
layout(std430, binding = 1) readonly buffer State { ExposureState state; };
layout(location = 0) uniform float exposure;
layout(location = 1) uniform float glow_share;
layout(std430, binding = 0) buffer Count { uint nonfinite; };
layout(location = 0) out vec4 display;

// The glow between its texels, which are four pixels wide, as a cubic B-spline in four bilinear reads (Sigg &
// Hadwiger 2005): about a disc far brighter than white straight lines between them would show as a square.
vec3 glow_at(vec2 at) {
  vec2 size = vec2(textureSize(glow, 0));
  vec2 f = fract(at * size - 0.5), g = 1.0 - f;
  vec2 first = floor(at * size - 0.5);
  vec2 w0 = g * g * g / 6.0, w3 = f * f * f / 6.0;
  vec2 w1 = 2.0 / 3.0 - 0.5 * f * f * (1.0 + g);
  vec2 low = w0 + w1, high = 1.0 - low;
  vec2 at_low = (first + w1 / low - 0.5) / size, at_high = (first + w3 / high + 1.5) / size;
  vec3 below = mix(textureLod(glow, vec2(at_high.x, at_low.y), 0.0).rgb, textureLod(glow, at_low, 0.0).rgb, low.x);
  vec3 above = mix(textureLod(glow, at_high, 0.0).rgb, textureLod(glow, vec2(at_low.x, at_high.y), 0.0).rgb, low.x);
  return mix(above, below, low.y);
}

void main() {
  vec3 colour = texelFetch(hdr, ivec2(gl_FragCoord.xy), 0).rgb;
  // Finite half floats have a finite sum.
  float sum = abs(colour.r) + abs(colour.g) + abs(colour.b);
  if (isnan(sum) || isinf(sum)) {
    atomicAdd(nonfinite, 1u);
    colour = vec3(0.0);
  }
  vec2 at = gl_FragCoord.xy / vec2(textureSize(hdr, 0));
  colour = mix(colour, glow_at(at), glow_share);
#ifdef NIGHT
  colour = night_sight(colour, rod_share(colour_luminance(colour) / exposure));
#endif
  colour *= state.factor;
#ifdef EXPONENTIAL
  vec3 shown = srgb_from_linear(clamp(tonemap_exponential(colour), vec3(0.0), vec3(1.0)));
#else
  vec3 shown = display_filmic(min(colour, vec3(1.0e9)));
#endif
  vec3 noise = vec3(dither(gl_FragCoord.xy), dither(gl_FragCoord.xy + vec2(47.0, 17.0)),
                    dither(gl_FragCoord.xy + vec2(13.0, 71.0)));
  display = vec4(shown + noise, 1.0);
}
