// Everything behind sea, boat and clouds: sky, sun, moon, and beyond the sea's mesh more sea.
#include "shared/frame.h"
#include "sky/sky.glsl"

layout(binding = OFFING_UNIT_TRANSMITTANCE) uniform sampler2D transmittance_table;

layout(location = 0) in vec3 ray;
layout(location = 0) out vec4 colour;

const float kBrightest = 60000.0;  // just below what half floats hold

vec3 transmittance(float cosine) {
  vec2 unit = transmittance_units(sky.observer.x, max(cosine, -sky.observer.y));
  vec2 at = 0.5 / sky.table_texels.zw + unit * (1.0 - 1.0 / sky.table_texels.zw);
  return textureLod(transmittance_table, at, 0.0).rgb;
}

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

// Cosine and sine of a small angle between unit vectors, exact where the cosine alone is not.
float sine_between(vec3 a, vec3 b) { return length(cross(a, b)); }

// How much of this pixel a disc of this radius covers (sines of small angles).
float disc_cover(float sine, float radius) {
  return clamp(0.5 + (radius - sine) / frame.camera.w, 0.0, 1.0);
}

vec3 moon_disc(vec3 d, float sine, float radius) {
  vec3 toward = frame.moon_direction.xyz;
  vec3 pole = normalize(sky.world_from_equatorial[2].xyz);
  vec3 right = normalize(cross(toward, pole));
  vec3 above = cross(right, toward);
  vec3 offset = (d - toward * dot(d, toward)) / radius;
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

// Open sea too far away to have waves of its own: the sky that its slopes reflect, through the air.
vec3 distant_sea(vec3 d) {
  const float kSlope = 0.22;         // root mean square slope that turns grazing rays upward
  const float kReflectance = 0.38;   // of a rough sea near the horizon (Preisendorfer & Mobley 1986)
  float down = max(-d.y, 1.0e-4);
  vec3 up = normalize(vec3(d.x, down + kSlope, d.z));
  vec3 water = frame.sky_illuminance.rgb / kPhasePi * vec3(0.004, 0.018, 0.030);
  vec3 sun = frame.sun_illuminance.rgb * max(frame.sun_direction.y, 0.0) / kPhasePi;
  vec3 sea = kReflectance * sky_radiance(up) + water + sun * vec3(0.002, 0.009, 0.015);
  AirLight air = air_light(d, frame.camera.y / down);
  return sea * air.transmittance + air.inscattered;
}

void main() {
  vec3 d = normalize(ray);
  float above = d.y + sky.observer.y;  // sine of the angle above the horizon, near it
  vec3 radiance = sky_radiance(d);

  float sun_radius = sqrt(1.0 - frame.sun_direction.w * frame.sun_direction.w);
  float moon_radius = sqrt(1.0 - frame.moon_direction.w * frame.moon_direction.w);
  float sun_sine = sine_between(d, frame.sun_direction.xyz);
  float moon_sine = sine_between(d, frame.moon_direction.xyz);
  bool at_sun = dot(d, frame.sun_direction.xyz) > 0.0 && sun_sine < sun_radius + frame.camera.w;
  bool at_moon = dot(d, frame.moon_direction.xyz) > 0.0 && moon_sine < moon_radius + frame.camera.w;
  if (at_sun || at_moon) {
    vec3 behind = vec3(0.0);
    if (at_sun) {
      float mean = 1.0 / (kPhasePi * sun_radius * sun_radius * max(sky.sun_source.w, 1.0e-6));
      behind = sky.sun_source.rgb * mean * limb_darkening(min(sun_sine / sun_radius, 1.0)) *
               disc_cover(sun_sine, sun_radius);
    }
    if (at_moon) {
      behind = mix(behind, moon_disc(d, moon_sine, moon_radius), disc_cover(moon_sine, moon_radius));
    }
    radiance += behind * transmittance(d.y);
  }

  // The horizon lies where it does to a fraction of a pixel.
  float sea_share = clamp(0.5 - above / frame.camera.w, 0.0, 1.0);
  if (sea_share > 0.0) radiance = mix(radiance, distant_sea(d), sea_share);
  colour = vec4(min(radiance * frame.time.z, vec3(kBrightest)), 1.0);
}
