// The sun's disc, dimmed toward its limb, and its corona, both less what the moon covers; added to the sky
// before it.
#include "shared/frame.h"
#include "sky/sky.glsl"
#include "lib/night.glsl"
#include "lib/noise.glsl"
#include "sky/pixel.glsl"
#include "sky/disc.glsl"

layout(location = 0) uniform vec4 body;
layout(location = 1) uniform vec4 moon;
layout(location = 2) uniform vec2 look;  // x: height over width of the disc, y: 1 where the corona shows
layout(location = 0) out vec4 colour;

// The corona falls by a thousand within three radii: more than a picture holds beside the sky at that hour,
// though not more than an eye. Its range is pressed together where it would be shown too bright; a few
// streamers lie along the ecliptic.
vec3 shown_corona(vec3 d, float radii, float mean) {
  const float kReach = 8.0;     // radii, as drawn in totality (sky.cpp)
  const float kBrightest = 1.8;  // as radiance × exposure
  vec3 offset = normalize(d - body.xyz + vec3(1.0e-9));
  float streamers = 1.0 + 0.9 * gradient_noise(offset * 2.1 + vec3(4.7)).value;
  float real = look.y * corona(max(radii, 1.0)) * sky.sun_source.g * mean * max(streamers, 0.1);
  float limb = corona(1.0) * sky.sun_source.g * mean;
  float pressed = kBrightest / frame.time.z * pow(max(real / limb, 1.0e-9), 0.36) * look.y;
  float fade = max(1.0 - radii / kReach, 0.0);
  return vec3(min(real, pressed) * fade);
}

void main() {
  vec3 seen = pixel_direction();
  vec3 d = unsqueezed(seen, body.xyz, look.x);
  float sine = sine_between(d, body.xyz);
  float mean = 1.0 / (kPhasePi * body.w * body.w * sky.sun_source.w);
  float moon_cover = disc_cover(sine_between(d, unsqueezed(moon.xyz, body.xyz, look.x)), moon.w);
  // What the sun's edge has of a pixel less what the moon has: their product would leave a ring of
  // full sunlight in totality.
  float bare = max(disc_cover(sine, body.w) - moon_cover, 0.0);
  vec3 radiance = sky.sun_source.rgb * mean * limb_darkening(min(sine / body.w, 1.0)) * bare +
                  shown_corona(d, sine / body.w, mean) * (1.0 - moon_cover);
  radiance *= air_transmittance(seen.y) * step(0.0, dot(seen, body.xyz)) * step(-sky.observer.y, seen.y);
  colour = vec4(min(radiance * frame.time.z, vec3(kBrightest)), 0.0);
}
