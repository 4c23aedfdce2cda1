// The moon: a sphere lit by the sun and, faintly, by the earth, in whose shadow it may stand; added to the
// sky before it.
#include "shared/frame.h"
#include "sky/sky.glsl"
#include "lib/night.glsl"
#include "lib/noise.glsl"
#include "sky/pixel.glsl"
#include "sky/disc.glsl"

layout(location = 0) uniform vec4 body;
layout(location = 1) uniform vec4 sun;         // xyz: toward the sun from there, w: height over width of the disc
layout(location = 2) uniform vec4 shadow;      // xyz: from the moon's centre to the shadow's axis, moon radii
layout(location = 4) uniform vec2 shadow_radii;  // umbra, penumbra, moon radii
layout(location = 5) uniform mat4 moon_from_world;  // x: middle of the near side, y: its east, z: its north
layout(location = 6) uniform vec2 light;  // x: mean of what the shadow leaves, y: lux on a surface facing it
layout(location = 0) out vec4 colour;

// An eye that is used to the night sees seas on a moon a hundred thousand times brighter than the sky
// beside it, and glare round it; a picture shows one white. So the disc is held at the brightness, and
// the dark part of it at that, which still have shades, and what it loses comes back as glare.
const float kBrightestMoon = 1.2;
const float kBrightestEarthshine = 0.10;
const float kBrightestGlare = 0.4;
const float kReach = 16.0;  // radii, as drawn at night (sky.cpp)

// The seas, as one sees them with the naked eye: selenographic latitude and longitude (east positive),
// radius in degrees, darkness.
const vec4 kSeas[18] = vec4[](
    vec4(33.0, -16.0, 18.5, 0.90),   // Imbrium
    vec4(27.0, 18.0, 11.5, 0.90),    // Serenitatis
    vec4(9.0, 30.0, 13.5, 1.00),     // Tranquillitatis
    vec4(17.0, 59.0, 7.5, 1.00),     // Crisium
    vec4(-5.0, 51.0, 11.0, 0.85),    // Fecunditatis
    vec4(-15.0, 35.0, 6.0, 0.85),    // Nectaris
    vec4(-20.0, -17.0, 12.0, 0.80),  // Nubium
    vec4(-24.0, -39.0, 7.0, 0.95),   // Humorum
    vec4(-10.0, -23.0, 7.5, 0.80),   // Cognitum
    vec4(4.0, -33.0, 13.0, 0.75),    // Insularum
    vec4(20.0, -55.0, 15.0, 0.95),   // Procellarum
    vec4(2.0, -50.0, 13.0, 0.90),    // Procellarum, south
    vec4(40.0, -48.0, 13.0, 0.90),   // Procellarum, north
    vec4(13.0, 4.0, 5.5, 0.80),      // Vaporum
    vec4(2.0, 1.0, 4.5, 0.70),       // Sinus Medii
    vec4(56.0, -20.0, 7.0, 0.65),    // Frigoris
    vec4(57.0, 5.0, 6.5, 0.65),      // Frigoris
    vec4(55.0, 25.0, 6.5, 0.60));    // Frigoris
// Young craters with bright rays: latitude, longitude, reach in degrees, brightness.
const vec4 kRays[4] = vec4[](
    vec4(-43.3, -11.4, 16.0, 0.40),  // Tycho
    vec4(9.6, -20.1, 7.0, 0.35),     // Copernicus
    vec4(8.1, -38.0, 4.5, 0.35),     // Kepler
    vec4(23.7, -47.4, 3.5, 0.50));   // Aristarchus

vec3 selenographic(vec2 place) {
  vec2 a = radians(place);
  return vec3(cos(a.x) * cos(a.y), cos(a.x) * sin(a.y), sin(a.x));
}

// Relative to the mean of the near side. `blur`: a pixel's width on the moon, radii.
float moon_albedo(vec3 place, float blur) {
  float coarse = gradient_noise(place * 3.7 + vec3(3.1, 7.7, 1.3)).value;
  float fine = gradient_noise(place * 11.0 + vec3(9.2, 1.4, 5.5)).value;
  float dark = 0.0, bright = 0.0;
  for (int i = 0; i < 18; ++i) {
    float away = length(place - selenographic(kSeas[i].xy)) / radians(kSeas[i].z);
    float shore = 0.22 + blur / radians(kSeas[i].z);
    dark = max(dark, kSeas[i].w * (1.0 - smoothstep(1.0 - shore, 1.0 + shore, away + 0.28 * coarse + 0.16 * fine)));
  }
  for (int i = 0; i < 4; ++i) {
    float away = length(place - selenographic(kRays[i].xy)) / radians(kRays[i].z);
    bright += kRays[i].w * exp(-1.5 * away * (1.0 + 0.8 * fine));
  }
  return 1.19 * (1.0 - 0.47 * dark * (1.0 - 0.15 * fine)) * (1.0 + bright) * (1.0 + 0.10 * fine + 0.06 * coarse);
}

// Of a point of the disc: x to the right, y up, within the unit circle.
vec3 lit_surface(vec2 p, vec3 right, vec3 above, float held, float earthshine) {
  float out_of_plane = sqrt(max(1.0 - dot(p, p), 0.0));
  vec3 normal = right * p.x + above * p.y - body.xyz * out_of_plane;
  // Lommel and Seeliger: a full moon is as bright at the limb as in the middle.
  float lit = max(dot(normal, sun.xyz), 0.0);
  float reflected = 2.0 * lit / max(lit + out_of_plane, 1.0e-3);
  vec3 off_axis = normal - shadow.xyz;
  off_axis -= sun.xyz * dot(off_axis, sun.xyz);
  return reflected * held * earth_shadow(length(off_axis), shadow_radii.x, shadow_radii.y) +
         earthshine * vec3(0.93, 1.0, 1.10);
}

void main() {
  vec3 seen = pixel_direction();
  vec3 d = unsqueezed(seen, body.xyz, sun.w);
  vec3 right = normalize(cross(body.xyz, vec3(0.0, 1.0, 1.0e-4)));
  vec3 above = cross(right, body.xyz);
  vec2 p = vec2(dot(d, right), dot(d, above)) / body.w;
  float pixel = frame.camera.w / body.w;
  // The terminator and the limb are as sharp as a pixel allows: 16 places of each.
  const int kSide = 4;
  vec2 across = dFdx(p), up = dFdy(p);
  float exposure = max(frame.time.z, 1.0e-12);
  float kept = min(1.0, kBrightestMoon / (sky.moon_source.w * light.x * exposure));
  float held = kept * sky.moon_source.w;
  float earthshine = min(sky.night.w, kBrightestEarthshine / exposure);
  vec3 radiance = vec3(0.0);
  for (int i = 0; i < kSide * kSide; ++i) {
    vec2 offset = (vec2(i % kSide, i / kSide) + 0.5) / float(kSide) - 0.5;
    vec2 q = p + offset.x * across + offset.y * up;
    float cover = clamp(0.5 + (1.0 - length(q)) / pixel * float(kSide), 0.0, 1.0);
    radiance += cover * lit_surface(q / max(length(q), 1.0), right, above, held, earthshine);
  }
  vec2 inside = p / max(length(p), 1.0);
  vec3 normal = right * inside.x + above * inside.y - body.xyz * sqrt(max(1.0 - dot(inside, inside), 0.0));
  vec3 face = (moon_from_world * vec4(normal, 0.0)).xyz;
  radiance *= moon_albedo(face, pixel) * moon_colour() / float(kSide * kSide);
  radiance *= air_transmittance(seen.y);
  // The eye's stray light is 10 lux / degrees^2 in cd/m^2 beyond a degree (Stiles & Holladay); a tenth
  // of that is enough on a display, before which the viewer's own eye works. It ends with the square.
  float away = max(length(p), 1.0);
  float fade = max(1.0 - away / kReach, 0.0);
  float degrees_away = degrees(body.w) * away;
  float glare = (1.0 - kept) * light.y / (degrees_away * degrees_away + 0.2) * fade * fade;
  radiance += moon_colour() * glare / (1.0 + glare * exposure / kBrightestGlare);
  radiance *= step(0.0, dot(seen, body.xyz)) * step(-sky.observer.y, seen.y);
  colour = vec4(min(radiance * frame.time.z, vec3(kBrightest)), 0.0);
}
