// The stars as points: one vertex each, turned with the sidereal time, lifted and dimmed by the air.
#include "shared/frame.h"
#include "lib/phase.glsl"
#include "lib/scattering.glsl"
#include "lib/night.glsl"
#include "shared/bindings.h"
#include "shared/sky.h"

layout(binding = OFFING_UNIT_TRANSMITTANCE) uniform sampler2D transmittance_table;
layout(location = 0) in vec4 star;           // xyz: direction (J2000), w: illuminance above the air, lux
layout(location = 1) in vec4 tint;           // rgb: linear colour of luminance 1, w: twinkling's seed
layout(location = 0) flat out vec3 light;    // radiance × exposure at the middle of the point
layout(location = 1) flat out vec2 centre;   // pixels

const float kPointPixels = 5.0;
// Sum over pixels of the point spread, in pixels: 2 pi times the square of stars.frag's 0.65.
const float kSpread = 2.0 * 3.14159265 * 0.65 * 0.65;

void main() {
  vec3 d = (sky.world_from_j2000 * vec4(star.xyz, 0.0)).xyz;
  float elevation = degrees(asin(clamp(d.y, -1.0, 1.0)));
  float seen = radians(elevation + star_refraction(elevation));
  d = vec3(d.xz * (cos(seen) / max(length(d.xz), 1.0e-6)), sin(seen)).xzy;
  gl_PointSize = kPointPixels;
  gl_Position = frame.clip_from_relative * vec4(d, 0.0);
  gl_Position.z = 0.0;
  light = vec3(0.0);
  centre = vec2(0.0);
  bool behind_moon = dot(d, frame.moon_direction.xyz) > frame.moon_direction.w;
  if (gl_Position.w <= 0.0 || d.y < -sky.observer.y || behind_moon) {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);  // clipped
    return;
  }
  centre = (gl_Position.xy / gl_Position.w * 0.5 + 0.5) * frame.viewport.xy;
  vec2 unit = transmittance_units(sky.observer.x, max(d.y, -sky.observer.y));
  vec2 at = 0.5 / sky.table_texels.zw + unit * (1.0 - 1.0 / sky.table_texels.zw);
  vec3 air = mix(vec3(1.0), srgb_from_bands(textureLod(transmittance_table, at, 0.0).rgb), sky.lights.z);
  float mass = air_mass(d.y);
  float apart = 0.004 * mass;  // low stars flash in colours
  vec3 flicker = vec3(twinkle(frame.time.x, tint.w, mass, -apart), twinkle(frame.time.x, tint.w, mass, 0.0),
                      twinkle(frame.time.x, tint.w, mass, apart));
  // A pixel aside from the middle of the picture covers less of the sky, by the cube of the cosine; the
  // clip w of a unit vector is that cosine.
  float cosine = gl_Position.w;
  float pixel = frame.camera.w * frame.camera.w * cosine * cosine * cosine;  // steradians
  light = tint.rgb * air * flicker * (star.w / (pixel * kSpread) * frame.time.z * sky.observer.w);
}
