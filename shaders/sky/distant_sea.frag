// What lies below the horizon where the sea's mesh has ended: more sea. Blended over the sky by alpha.
#include "shared/frame.h"
#include "sky/sky.glsl"
#include "sky/pixel.glsl"

layout(location = 0) out vec4 colour;

// Open sea too far away to have waves of its own: the sky that its slopes reflect, through the air.
vec3 distant_sea(vec3 d) {
  const float kSlope = 0.22;         // root mean square slope that turns grazing rays upward
  const float kReflectance = 0.38;   // of a rough sea near the horizon (Preisendorfer & Mobley 1986)
  float down = max(-d.y, 1.0e-4);
  vec3 up = normalize(vec3(d.x, down + kSlope, d.z));
  vec3 water = frame.sky_illuminance.rgb / kPhasePi * vec3(0.004, 0.018, 0.030);
  vec3 sun = frame.sun_illuminance.rgb * max(frame.sun_direction.y, 0.0) / kPhasePi;
  vec3 sea = kReflectance * sky_radiance(up) + water + sun * vec3(0.002, 0.009, 0.015);
  AirLight air = air_light(d, max(frame.camera.y, 0.0) / down);
  return sea * air.transmittance + air.inscattered;
}

void main() {
  vec3 d = pixel_direction();
  // The horizon lies where it does to a fraction of a pixel.
  float share = clamp(0.5 - (d.y + sky.observer.y) / frame.camera.w, 0.0, 1.0);
  colour = vec4(min(distant_sea(d) * frame.time.z, vec3(kBrightest)), share);
}
