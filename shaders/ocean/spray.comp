// One step of the spray: what flies is carried along by the wind and falls; what has come down looks for a
// crest that breaks. See spray.h.
#include "shared/frame.h"
#include "shared/ocean.h"
#include "lib/water.glsl"
#include "ocean/surface.glsl"
#include "ocean/spray.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = 0) buffer Drops { Drop drops[]; };
layout(location = 0) uniform vec4 step_;  // x: s, negative: all anew; yz: the camera's way since the last (m); w: amount
layout(location = 1) uniform uint number;  // of the step

const float kReach = 180.0;      // m
const float kTries = 80.0;       // per second and drop at rest, of places in reach
const int kMostTries = 3;        // in one step
const float kResponse = 0.5;     // s in which drops take on the wind's speed
const float kFall = 3.0;         // m/s^2: fine drops fall slower than coarse ones
const float kCell = 0.6;         // m over which the sea is read

uint state = 0u;
float die() {
  state = state * 747796405u + 2891336453u;  // PCG (O'Neill 2014)
  uint word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
  return float((word >> 22) ^ word) / 4294967296.0;
}

// A place at random, if the sea breaks there.
Drop born(float chance) {
  // As many per metre of distance: what is near counts most.
  float distance = kReach * (0.03 + 0.97 * die()), heading = 2.0 * kWaterPi * die();
  vec2 q = distance * vec2(cos(heading), sin(heading));
  vec3 squeeze = vec3(0.0), displacement = vec3(0.0);
  for (int c = 0; c < int(ocean.foam.z); ++c) {
    float level = sea_map_level(c, kCell);
    vec3 at = sea_map_place(c, q);
    vec4 shape = textureLod(sea_displacement, at, level);
    displacement += shape.xyz;
    squeeze += vec3(textureLod(sea_slopes, at, level).zw, shape.w);
  }
  float jacobian = surface_jacobian(squeeze.x, squeeze.y, squeeze.z);
  float spread = sqrt(ocean.foam_share.z * sea_unresolved(kCell) + ocean.foam.w);
  float fresh = normal_below((ocean.foam.x - jacobian) / spread);
  vec2 wind = frame.wind.xz;
  Drop drop = Drop(vec4(0.0), vec4(0.0));
  if (fresh * chance > die()) {
    // Off the lip, up and ahead of it, as fast as crests of this sea run at the most.
    float lip = 0.35 + 0.25 * die();
    drop.place = vec4(vec3(q.x, 0.0, q.y) + displacement, 0.0);
    drop.velocity.xyz = vec3(wind.x, 0.0, wind.y) * lip +
                        (vec3(die(), die(), die()) - vec3(0.5, 0.1, 0.5)) * vec3(1.6, 2.2, 1.6);
    drop.velocity.w = mix(0.5, 1.6, die());
  }
  return drop;
}

void main() {
  uint i = gl_GlobalInvocationID.x;
  state = i * 0x9e3779b1u ^ number * 0x85ebca77u;
  die();
  Drop drop = drops[i];
  float dt = step_.x;
  drop.place.xz -= step_.yz;
  drop.place.w += dt;
  if (dt < 0.0 || drop.place.w >= drop.velocity.w) {
    drop.velocity.w = 0.0;
    for (int i = 0; i < kMostTries && drop.velocity.w <= 0.0; ++i) {
      drop = born(step_.w * min(kTries / float(kMostTries) * abs(dt), 1.0));
    }
  } else {
    vec3 air = vec3(frame.wind.x, 0.0, frame.wind.z) * 0.8;
    drop.velocity.xyz = mix(air, drop.velocity.xyz, exp(-dt / kResponse)) - vec3(0.0, kFall * dt, 0.0);
    drop.place.xyz += drop.velocity.xyz * dt;
  }
  drops[i] = drop;
}
