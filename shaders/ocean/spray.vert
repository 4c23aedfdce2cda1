// A drop cloud as a picture that faces the eye, drawn out along its way. Four corners each.
#include "shared/frame.h"
#include "sky/sky.glsl"
#include "sky/probe.glsl"
#include "clouds/shadow.glsl"
#include "lib/water.glsl"
#include "ocean/spray.glsl"
layout(std430, binding = 0) readonly buffer Drops { Drop drops[]; };

out vec2 corner;              // -1 … 1
flat out vec3 tuft;           // where in the pattern; its map level
flat out vec4 light;          // rgb: radiance × exposure; w: opacity

const int kTuftTexels = 256;  // of the pattern, across
const float kFirstSize = 0.15, kLastSize = 0.7;  // m, half a side
const float kOpacity = 0.28;
const float kTurbid = 0.85;  // share of the light that a cloud of drops sends back, all ways together

void main() {
  Drop drop = drops[gl_InstanceID];
  float age = drop.place.w / max(drop.velocity.w, 1.0e-3);
  vec3 relative = drop.place.xyz - vec3(0.0, frame.camera.y, 0.0);
  relative.y -= dot(relative.xz, relative.xz) / (2.0 * 6371.0e3);
  float distance = length(relative), size = mix(kFirstSize, kLastSize, sqrt(age));
  vec3 view = relative / max(distance, 1.0e-3);
  corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  gl_Position = vec4(0.0, 0.0, -1.0, 1.0);  // nowhere
  if (drop.velocity.w > 0.0 && age < 1.0 && distance > 0.7) {
    // Along the way as it is seen, and across it.
    vec3 way = drop.velocity.xyz - view * dot(drop.velocity.xyz, view);
    float speed = length(way);
    vec3 along = speed > 1.0e-3 ? way / speed : normalize(cross(view, vec3(0.0, 1.0, 0.01)));
    vec3 across = cross(along, view);
    float longer = 1.0 + 0.12 * speed;
    vec3 at = relative + size * (longer * corner.x * along + corner.y * across);
    gl_Position = frame.clip_from_relative * vec4(at, 1.0);
  }
  tuft.xy = fract(vec2(0.618034, 0.754878) * float(gl_InstanceID));
  tuft.z = log2(float(kTuftTexels) * kSprayTuft.y * distance * frame.camera.w / size);

  bool by_day = frame.sun_illuminance.g >= frame.moon_illuminance.g;
  vec3 toward = by_day ? frame.sun_direction.xyz : frame.moon_direction.xyz;
  vec3 direct = (by_day ? frame.sun_illuminance.rgb : frame.moon_illuminance.rgb) * cloud_shadow(relative);
  vec3 from_sky = probe_irradiance(vec3(0.0, 1.0, 0.0));
  // Scattered many times, and once, forward: brighter against the light (Henyey & Greenstein, g = .6).
  float cosine = dot(view, toward);
  float forward = 0.64 / pow(1.36 - 1.2 * cosine, 1.5);
  vec3 radiance = kTurbid / (4.0 * kWaterPi) * (direct * (0.6 + 0.6 * forward) + 2.0 * from_sky);
  float shown = smoothstep(1.0, 10.0, distance) * (1.0 - smoothstep(0.3, 1.0, age)) * smoothstep(0.0, 0.08, age);
  light = vec4(radiance * frame.time.z, kOpacity * shown);
}
