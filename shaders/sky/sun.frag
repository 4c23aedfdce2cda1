// The sun's disc, dimmed toward its limb and less what the moon covers; added to the sky before it.
#include "shared/frame.h"
#include "sky/sky.glsl"
#include "sky/pixel.glsl"
#include "sky/disc.glsl"

layout(location = 0) uniform vec4 body;
layout(location = 1) uniform vec4 moon;
layout(location = 0) out vec4 colour;

void main() {
  vec3 d = pixel_direction();
  float sine = sine_between(d, body.xyz);
  float mean = 1.0 / (kPhasePi * body.w * body.w * sky.sun_source.w);
  vec3 radiance = sky.sun_source.rgb * mean * limb_darkening(min(sine / body.w, 1.0)) *
                  disc_cover(sine, body.w) * (1.0 - disc_cover(sine_between(d, moon.xyz), moon.w));
  radiance *= air_transmittance(d.y) * step(0.0, dot(d, body.xyz));
  colour = vec4(min(radiance * frame.time.z, vec3(kBrightest)), 0.0);
}
