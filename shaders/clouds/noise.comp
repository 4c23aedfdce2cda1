// One noise volume, four channels (R may be connected and billowy at once; see shared/clouds.h).
#include "lib/noise.glsl"
#include "lib/cloud_noise.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba8, binding = 0) uniform writeonly image3D volume;
// Per channel: cells, octaves, persistence, lacunarity; then kind (0 cellular, 1 gradient, 2 both),
// inverted.
layout(location = 0) uniform vec4 octaves[4];
layout(location = 4) uniform vec4 kinds[4];

float channel_value(int c, vec3 at, int texels) {
  NoiseChannel channel = NoiseChannel(int(octaves[c].x), int(octaves[c].y), octaves[c].z,
                                      int(octaves[c].w), kinds[c].y);
  int kind = int(kinds[c].x);
  float value = 0.0;
  for (int i = 0; i < int(kind != 1); ++i) value = cellular_octaves(channel, at, texels, 11 * c);
  for (int i = 0; i < int(kind == 1); ++i) value = gradient_octaves(channel, at, texels, 11 * c);
  for (int i = 0; i < int(kind == 2); ++i) {
    NoiseChannel connected = NoiseChannel(channel.cells, 5, 0.55, 2, 0.0);
    value = perlin_worley(1.4 * gradient_octaves(connected, at, texels, 11 * c + 5) - 0.4, value);
  }
  return clamp(value, 0.0, 1.0);
}

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  ivec3 size = imageSize(volume);
  if (any(greaterThanEqual(texel, size))) return;
  vec3 at = (vec3(texel) + 0.5) / vec3(size);
  vec4 value = vec4(0.0);
  for (int c = 0; c < 4; ++c) value[c] = channel_value(c, at, size.x);
  imageStore(volume, texel, value);
}
