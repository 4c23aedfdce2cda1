// The sky itself, without discs and stars.
#include "shared/frame.h"
#include "sky/sky.glsl"
#include "sky/pixel.glsl"

layout(location = 0) out vec4 colour;

void main() {
  colour = vec4(min(sky_radiance(pixel_direction()) * frame.time.z, vec3(kBrightest)), 1.0);
}
