// Thin cloth: Lambert on the lit side, and part of the light through to the other.
#include "shared/frame.h"
#include "shared/boat.h"
#include "shared/cloth.h"
#include "boat/light.glsl"

layout(binding = 0) uniform sampler2D alpha_picture;
layout(binding = 1) uniform sampler2D pattern_picture;  // r: seen from port, g: from starboard

in Surface {
  vec3 relative;
  vec3 in_boat;
  vec3 normal;
  vec2 uv;
} surface;

layout(location = 0) out vec4 radiance;

// Illuminance that leaves on the viewer's side: what falls on it, and what comes through.
float faced(vec3 n, vec3 l, float through) {
  float cosine = dot(n, l);
  return cosine > 0.0 ? cosine * (1.0 - through) : -cosine * through;
}

void main() {
  if (texture(alpha_picture, surface.uv).r < 0.5) discard;
  float through = cloth.colour_a.w;
  vec2 pattern = texture(pattern_picture, surface.uv).rg;
  vec3 base = mix(cloth.colour_a.rgb, cloth.colour_b.rgb, gl_FrontFacing ? pattern.g : pattern.r);
  vec3 n = normalize(surface.normal);
  n = dot(n, surface.relative) > 0.0 ? -n : n;
  mat3 boat_from_world = transpose(mat3(boat.relative_from_boat));
  float cloud_light = cloud_shadow(surface.relative);
  vec3 light = ambient_illuminance(n) * (1.0 - through) +
               ambient_illuminance(-n) * through;
  for (int i = first_light(); i < last_light(); ++i) {
    vec3 l = light_direction(i);
    light += light_illuminance(i) * cloud_light * faced(n, l, through) *
             sail_shade(surface.in_boat, boat_from_world * l, int(cloth.colour_b.w));
  }
  vec3 seen = through_air(base / kHalfTurn * light, surface.relative);
  radiance = vec4(min(seen * frame.time.z, vec3(6.0e4)), 1.0);
}
