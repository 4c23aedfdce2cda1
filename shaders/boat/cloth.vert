// Sails and flag: a belly to leeward, twist, and gradient noise that travels with the wind.
#include "shared/frame.h"
#include "shared/boat.h"
#include "shared/cloth.h"
#include "lib/noise.glsl"
#include "shared/boat_shadow.h"
#ifndef SHADOW
#include "boat/light.glsl"
#endif

layout(location = 0) in vec3 position;  // flat, in the cloth's frame
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 tangents;  // d(y, z)/du, d(y, z)/dv of the flat cloth, m

#ifdef SHADOW
out vec2 cloth_uv;
#else
out Surface {
  vec3 relative;
  vec3 normal;
  vec2 uv;
  vec4 ambient;  // lux on the side of the normal; w: what the clouds leave of the sun
  vec3 behind;   // lux on the other side
  vec3 air;      // cd/m^2
} surface;
#endif

// How free the cloth is to move at (u, v).
float freedom(vec2 at) {
  vec4 from_edge = vec4(at.x, 1.0 - at.x, at.y, 1.0 - at.y);
  vec4 held = cloth.attached * (1.0 - smoothstep(0.0, 0.6, from_edge));
  vec4 free = 1.0 - held;
  return free.x * free.y * free.z * free.w;
}

// Where the point of the flat cloth at (u, v), position `flat_at`, is now.
vec3 place(vec2 at, vec2 flat_at, float chord) {
  float u = clamp(at.x, 0.0, 1.0);
  // Camber: a curve through both edges, deepest where asked: u^a (1-u)^b peaks at a/(a+b).
  float p = cloth.belly.z;
  float rise = 1.1 * p / (1.0 - p);
  float camber = pow(u, rise) * pow(1.0 - u, 1.1) / (pow(p, rise) * pow(1.0 - p, 1.1));
  float full = mix(cloth.stream.w, 1.0, smoothstep(0.0, 0.35, at.y));
  float luffing = cloth.gradient_weight.w;
  vec3 moved = vec3(0.0);
  moved.x = cloth.belly.x * chord * camber * full * (1.0 - 0.7 * luffing);
  moved.x += sin(cloth.belly.y * at.y) * chord * u;

  // Waves run down the chord; those of a shaking sail grow toward the leech.
  float scale = cloth.clock.y;
  vec3 p3 = vec3((flat_at.y - cloth.clock.z * cloth.clock.x) * scale, flat_at.x * scale * 0.6,
                 cloth.clock.x * 0.7);
  Noise noise = gradient_noise(p3);
  float height = cloth.clock.w * freedom(at) * u;
  moved += height * cloth.gradient_weight.xyz *
           vec3(noise.value, 0.5 * noise.gradient.y, 0.5 * noise.gradient.x);

  // The chord points down the stream: aft for a sail, down the wind and down for a flag.
  vec3 along = cloth.stream.xyz;
  return vec3(0.0, flat_at.x, 0.0) + along * (flat_at.y + moved.z) + vec3(moved.x, moved.y, 0.0);
}

void main() {
  float chord = length(tangents.xy);
  vec3 here = place(uv, position.yz, chord);
  mat4 boat_from_node = boat.boat_from_node[int(cloth.belly.w)];
  vec4 relative = boat.relative_from_boat * (boat_from_node * vec4(here, 1.0));
#ifdef SHADOW
  cloth_uv = uv;
  vec4 on_map = boat_shadow.map_from_relative * relative;
  gl_Position = vec4(2.0 * on_map.xy - 1.0, on_map.zw);
#else
  // Differences toward the middle, so that no edge looks outside the cloth.
  float du = uv.x < 0.5 ? 0.01 : -0.01;
  float dv = uv.y < 0.5 ? 0.01 : -0.01;
  vec3 along_u = (place(uv + vec2(du, 0.0), position.yz + du * tangents.xy, chord) - here) / du;
  vec3 along_v = (place(uv + vec2(0.0, dv), position.yz + dv * tangents.zw, chord) - here) / dv;
  vec3 normal = normalize(cross(along_v, along_u));

  surface.relative = relative.xyz;
  surface.normal = mat3(boat.relative_from_boat) * (mat3(boat_from_node) * normal);
  surface.uv = uv;
  vec3 n = normalize(surface.normal);
  surface.ambient = vec4(ambient_illuminance(n), cloud_shadow(relative.xyz));
  surface.behind = ambient_illuminance(-n);
  surface.air = light_of_air(relative.xyz);
  gl_Position = frame.clip_from_relative * relative;
#endif
}
