// The band of the Milky Way, added to the sky before it.
#include "shared/frame.h"
#include "sky/sky.glsl"
#include "sky/pixel.glsl"
#include "sky/disc.glsl"

layout(location = 1) uniform mat4 galactic_from_world;
layout(location = 2) uniform vec4 light;  // rgb: radiance where the map is 1, w: latitude (rad) it reaches
layout(binding = 0) uniform sampler2D map;
layout(location = 0) out vec4 colour;

void main() {
  vec3 d = pixel_direction();
  vec3 g = (galactic_from_world * vec4(d, 0.0)).xyz;
  vec2 at = vec2(atan(g.y, g.x) / (2.0 * kPhasePi), 0.5 - 0.5 * asin(clamp(g.z, -1.0, 1.0)) / light.w);
  // No levels of detail: texels are larger than pixels, and none across the seam of the longitude.
  float band = textureLod(map, at, 0.0).r;
  colour = vec4(light.rgb * (band * frame.time.z * sky.observer.w) * air_transmittance(d.y), 0.0);
}
