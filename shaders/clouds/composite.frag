// The clouds over what is behind them: blended as light + behind × transmittance.
#include "shared/frame.h"
#ifdef NEAR_THINGS
#include "clouds/density.glsl"
#endif

layout(binding = 0) uniform sampler2D seen;  // linear where its pixels are larger than the screen's
layout(location = 1) uniform vec2 units_of_pixel;
#ifdef NEAR_THINGS
layout(binding = 1) uniform sampler2D depth;
#endif
layout(location = 0) out vec4 colour;

void main() {
  colour = textureLod(seen, gl_FragCoord.xy * units_of_pixel, 0.0);
#ifdef NEAR_THINGS
  // From within and from above: what stands before the first possible cloud has none before it.
  vec4 at = vec4(2.0 * gl_FragCoord.xy * frame.viewport.zw - 1.0, texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r, 1.0);
  vec4 thing = frame.relative_from_clip * at;
  float distance = at.z > 0.0 ? length(thing.xyz / thing.w) : 1.0e9;
  vec4 far = frame.relative_from_clip * vec4(at.xy, 1.0, 1.0);
  CloudSpan span = cloud_span(vec3(0.0), normalize(far.xyz / far.w));
  if (distance < span.near + 1.0) colour = vec4(0.0, 0.0, 0.0, 1.0);
#endif
}
