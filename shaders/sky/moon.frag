// The moon: a sphere lit by the sun and, faintly, by the earth; added to the sky before it.
#include "shared/frame.h"
#include "sky/sky.glsl"
#include "sky/pixel.glsl"
#include "sky/disc.glsl"

layout(location = 0) uniform vec4 body;
layout(location = 0) out vec4 colour;

float value_noise(vec3 p) {
  vec3 cell = floor(p), f = p - cell;
  f = f * f * (3.0 - 2.0 * f);
  float corners[8];
  for (int i = 0; i < 8; ++i) {
    vec3 q = cell + vec3(i & 1, (i >> 1) & 1, i >> 2);
    corners[i] = fract(sin(dot(q, vec3(127.1, 311.7, 74.7))) * 43758.5453);
  }
  vec4 x = mix(vec4(corners[0], corners[2], corners[4], corners[6]),
               vec4(corners[1], corners[3], corners[5], corners[7]), f.x);
  vec2 y = mix(x.xz, x.yw, f.y);
  return mix(y.x, y.y, f.z);
}

vec3 moon_disc(vec3 d) {
  vec3 toward = body.xyz;
  vec3 pole = normalize(sky.world_from_equatorial[2].xyz);
  vec3 right = normalize(cross(toward, pole));
  vec3 above = cross(right, toward);
  vec3 offset = (d - toward * dot(d, toward)) / body.w;
  vec2 p = vec2(dot(offset, right), dot(offset, above));
  p /= max(length(p), 1.0);
  float out_of_plane = sqrt(max(1.0 - dot(p, p), 0.0));
  vec3 normal = right * p.x + above * p.y - toward * out_of_plane;
  // Lommel and Seeliger: a full moon is as bright at the limb as in the middle.
  float lit = max(dot(normal, frame.sun_direction.xyz), 0.0);
  float reflected = 2.0 * lit / max(lit + out_of_plane, 1.0e-3);
  vec3 face = vec3(p, out_of_plane);
  float seas = 0.65 * value_noise(face * 2.3 + vec3(3.1, 7.7, 1.3)) +
               0.35 * value_noise(face * 6.1 + vec3(9.2, 1.4, 5.5));
  float albedo = mix(1.12, 0.62, smoothstep(0.42, 0.62, seas));
  return albedo * (reflected * sky.moon_source.w + sky.night.w) * vec3(1.03, 1.0, 0.93);
}

void main() {
  vec3 d = pixel_direction();
  vec3 radiance = moon_disc(d) * disc_cover(sine_between(d, body.xyz), body.w) *
                  air_transmittance(d.y) * step(0.0, dot(d, body.xyz));
  colour = vec4(min(radiance * frame.time.z, vec3(kBrightest)), 0.0);
}
