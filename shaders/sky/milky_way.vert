// The band of the Milky Way as a mesh in galactic coordinates, infinitely far, turned with the stars.
#include "shared/frame.h"
#include "sky/sky.glsl"
#include "sky/disc.glsl"

layout(location = 0) uniform mat4 world_from_galactic;
layout(location = 1) uniform vec4 light;  // rgb: radiance where the map is 1, w: latitude (rad) it reaches
layout(location = 0) out vec2 at;           // in the map
layout(location = 1) out vec3 radiance;     // times exposure, where the map is 1
layout(location = 2) out float above;       // sine above the horizon, roughly

const ivec2 kCells = ivec2(72, 20);  // of 5 degrees

void main() {
  int cell = gl_VertexID / 6, corner = gl_VertexID % 6;
  ivec2 step = ivec2(corner == 1 || corner == 2 || corner == 4, corner == 2 || corner == 4 || corner == 5);
  at = vec2(ivec2(cell % kCells.x, cell / kCells.x) + step) / vec2(kCells);
  float longitude = 2.0 * kPhasePi * at.x, latitude = (1.0 - 2.0 * at.y) * light.w;
  vec3 d = (world_from_galactic * vec4(cos(latitude) * cos(longitude), cos(latitude) * sin(longitude),
                                       sin(latitude), 0.0)).xyz;
  radiance = light.rgb * (frame.time.z * sky.observer.w) * air_transmittance(d.y);
  above = d.y + sky.observer.y;
  gl_Position = frame.clip_from_relative * vec4(d, 0.0);
  gl_Position.z = 0.0;
}
