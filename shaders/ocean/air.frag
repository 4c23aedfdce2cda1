// The strip of air.glsl: radiance of the sky at the horizon.
#include "shared/frame.h"
#include "sky/sky.glsl"
#include "ocean/air.glsl"

layout(location = 0) out vec4 colour;
layout(location = 0) uniform float width;  // of the strip, texels

void main() {
  vec2 heading = normalize(horizon_heading(gl_FragCoord.x / width));
  colour = vec4(sky_radiance(vec3(heading.x, -sky.observer.y, heading.y)), 1.0);
}
