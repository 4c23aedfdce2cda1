// What falls on the boat: sun, moon, sky and sea, with the shadows of sails and clouds.
#include "sky/sky.glsl"
#include "sky/probe.glsl"
#include "clouds/shadow.glsl"

const float kHalfTurn = 3.14159265358979323846;
const float kSailTransmittance = 0.22;

// The share of light from `direction` (boat frame) that passes the sails on its way to `p`.
float sail_shade(vec3 p, vec3 direction, int own) {
  float light = 1.0;
  for (int i = 0; i < 2; ++i) {
    SailShade sail = boat.sails[i];
    float across = dot(direction, sail.normal.xyz);
    across = abs(across) < 1.0e-4 ? 1.0e-4 : across;
    vec3 from_foot = p - sail.origin.xyz;
    float t = -dot(from_foot, sail.normal.xyz) / across;
    vec3 hit = from_foot + t * direction;
    float y = dot(hit, sail.luff.xyz);
    float z = dot(hit, sail.chord.xyz);
    float leech = mix(sail.luff.w, sail.chord.w, y / max(sail.origin.w, 1.0e-3));
    // The half shadow grows with the distance as the sun's disc does; cloth is not quite where its
    // plane is.
    float blur = 0.04 + 0.01 * abs(t);
    float inside = smoothstep(-blur, blur, z) * smoothstep(-blur, blur, leech - z) *
                   smoothstep(-blur, blur, y - sail.normal.w * z) *
                   smoothstep(-blur, blur, sail.origin.w - y);
    bool counts = t > 0.05 && i != own && sail.origin.w > 0.0;
    light *= 1.0 - (counts ? (1.0 - kSailTransmittance) * inside : 0.0);
  }
  return light;
}

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

// The place in the boat's frame.
vec3 in_boat_frame(mat3 boat_from_world, vec3 relative) {
  return boat_from_world * (relative - boat.relative_from_boat[3].xyz);
}

// Light 0 is the sun, light 1 the moon. Only those that count are gone through: by day the moon does
// not, by night the sun does not. (Bounds of a loop save work where a branch would not.)
int first_light() { return frame.sun_illuminance.g > 0.0 ? 0 : 1; }
int last_light() {
  return frame.moon_illuminance.g > 1.0e-3 * frame.sun_illuminance.g ? 2 : 1;
}
vec3 light_direction(int i) { return i == 0 ? frame.sun_direction.xyz : frame.moon_direction.xyz; }
vec3 light_illuminance(int i) { return i == 0 ? frame.sun_illuminance.rgb : frame.moon_illuminance.rgb; }
