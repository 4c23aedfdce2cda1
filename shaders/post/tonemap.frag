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

void main() {
  vec3 colour = texelFetch(hdr, ivec2(gl_FragCoord.xy), 0).rgb;
  // Finite half floats have a finite sum.
  float sum = abs(colour.r) + abs(colour.g) + abs(colour.b);
  if (isnan(sum) || isinf(sum)) {
    atomicAdd(nonfinite, 1u);
    colour = vec3(0.0);
  }
  vec2 at = gl_FragCoord.xy / vec2(textureSize(hdr, 0));
  colour = mix(colour, textureLod(glow, at, 0.0).rgb, glow_share);
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
