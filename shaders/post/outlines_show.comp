// Puts the smoothed pixels into the picture.
#include "post/outlines.glsl"
layout(local_size_x = 64) in;
layout(rgba8, binding = 0) writeonly uniform image2D display;

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= min(outlines.count, uint(outlines.pixels.length()))) return;
  uvec2 pixel = outlines.pixels[i];
  imageStore(display, ivec2(pixel.x & 0xffffu, pixel.x >> 16), unpackUnorm4x8(pixel.y));
}
