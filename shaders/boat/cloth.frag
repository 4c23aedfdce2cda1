// Thin cloth: Lambert on the lit side, and part of the light through to the other.
#include "shared/frame.h"
#include "shared/boat.h"
#include "shared/cloth.h"
#include "boat/light.glsl"

// r: the pattern seen from port, g: from starboard, b: where there is cloth
layout(binding = 0) uniform sampler2D cloth_picture;

in Surface {
  vec3 relative;
  vec3 normal;
  vec2 uv;
  vec4 ambient;  // lux on the side of the normal; w: what the clouds leave of the sun
  vec3 behind;   // lux on the other side
  vec3 air;      // cd/m^2
} surface;

layout(location = 0) out vec4 radiance;

// Illuminance that leaves on the viewer's side: what falls on it, and what comes through.
float faced(vec3 n, vec3 l, float through) {
  float cosine = dot(n, l);
  return cosine > 0.0 ? cosine * (1.0 - through) : -cosine * through;
}

void main() {
  vec3 picture = texture(cloth_picture, surface.uv).rgb;
  if (picture.b < 0.5) discard;
  float through = cloth.colour_a.w;
  vec3 base = mix(cloth.colour_a.rgb, cloth.colour_b.rgb, gl_FrontFacing ? picture.g : picture.r);
  vec3 n = normalize(surface.normal);
  float facing = dot(n, surface.relative) > 0.0 ? -1.0 : 1.0;
  n *= facing;
  vec3 light = mix(surface.ambient.rgb, surface.behind, facing > 0.0 ? through : 1.0 - through);
  for (int i = first_light(); i < last_light(); ++i) {
    vec3 l = light_direction(i);
    light += light_illuminance(i) * surface.ambient.w * faced(n, l, through) *
             light_share(i, surface.relative, dot(n, l) > 0.0 ? n : -n);
  }
  vec3 seen = through_air(base / kHalfTurn * light, surface.relative, surface.air);
  radiance = vec4(min(seen * frame.time.z, vec3(6.0e4)), 1.0);
}
