// The stars as points: one vertex each, turned with the sidereal time.
#include "shared/frame.h"
#include "lib/phase.glsl"
#include "lib/scattering.glsl"
#include "shared/bindings.h"
#include "shared/sky.h"

layout(binding = OFFING_UNIT_TRANSMITTANCE) uniform sampler2D transmittance_table;
layout(location = 0) in vec4 star;    // xyz: equatorial direction, w: magnitude
layout(location = 1) in vec4 tint;    // rgb: linear colour of luminance 1
layout(location = 0) out vec3 light;  // radiance × exposure at the middle of the point

const float kPointPixels = 3.0;
// A Gaussian of standard deviation 0.6 pixels spreads over this many pixels.
const float kSpread = 2.0 * 3.14159265 * 0.6 * 0.6;

void main() {
  vec3 d = (sky.world_from_equatorial * vec4(star.xyz, 0.0)).xyz;
  gl_PointSize = kPointPixels;
  gl_Position = frame.clip_from_relative * vec4(d, 0.0);
  gl_Position.z = 0.0;
  light = vec3(0.0);
  bool behind_moon = dot(d, frame.moon_direction.xyz) > frame.moon_direction.w;
  if (gl_Position.w <= 0.0 || d.y < -sky.observer.y || behind_moon) {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);  // clipped
    return;
  }
  vec2 unit = transmittance_units(sky.observer.x, d.y);
  vec2 at = 0.5 / sky.table_texels.zw + unit * (1.0 - 1.0 / sky.table_texels.zw);
  vec3 air = textureLod(transmittance_table, at, 0.0).rgb;
  float lux = sky.aerosol.w * pow(10.0, -0.4 * star.w);
  float pixel = frame.camera.w * frame.camera.w;  // steradians
  light = min(tint.rgb * air * (lux / (pixel * kSpread) * frame.time.z * sky.observer.w), vec3(1000.0));
}
