// What falls on the boat: sun, moon, sky and sea, with the shadows of clouds and of the boat herself.
#include "sky/sky.glsl"
#include "sky/probe.glsl"
#include "clouds/shadow.glsl"
#include "boat/shadow.glsl"

const float kHalfTurn = 3.14159265358979323846;

// Illuminance (lux) of a surface with this normal from sky and sea, without sun and moon.
vec3 ambient_illuminance(vec3 normal) { return probe_irradiance(normal); }

// The light of the air (cd/m^2) between the eye and a place. It changes over tens of metres, so it is
// found at vertices and interpolated, as clouds' shadow and the light from all round are.
vec3 light_of_air(vec3 relative) {
  float distance_ = length(relative);
  return air_light(relative / max(distance_, 1.0e-3), distance_).inscattered;
}

// What is left of `radiance` (cd/m^2) through the air between, with the light of that air.
vec3 through_air(vec3 radiance, vec3 relative, vec3 inscattered) {
  return radiance * exp(-frame.haze.rgb * length(relative)) + inscattered;
}

// Light 0 is the sun, light 1 the moon. Only those that count are gone through: by day the moon does
// not, by night the sun does not. (Bounds of a loop save work where a branch would not.)
int first_light() { return frame.sun_illuminance.g > 0.0 ? 0 : 1; }
int last_light() {
  return frame.moon_illuminance.g > 1.0e-3 * frame.sun_illuminance.g ? 2 : 1;
}
vec3 light_direction(int i) { return i == 0 ? frame.sun_direction.xyz : frame.moon_direction.xyz; }
vec3 light_illuminance(int i) { return i == 0 ? frame.sun_illuminance.rgb : frame.moon_illuminance.rgb; }
// Share of it that passes the boat on its way to a place with this normal.
float light_share(int i, vec3 relative, vec3 normal) {
  const float kOff = 0.04;  // m: no surface lies in its own shadow
  return i == int(boat_shadow.light.w) ? boat_shade(relative + kOff * normal) : 1.0;
}
