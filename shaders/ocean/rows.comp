// The second half of the transform, along x, and the maps of what it gives. One group per row and
// cascade, so that map points are written side by side.
#include "ocean/fft.glsl"
layout(local_size_x = kThreads) in;

layout(std430, binding = 2) readonly buffer Work { vec2 work[]; };  // [cascade][field][z][stored x]
layout(std430, binding = 3) readonly buffer Grids { vec4 grids[]; };  // w: scale S of Dxz
layout(binding = 0) uniform writeonly image2DArray displacement;    // Dx, h, Dz, Dxz
layout(binding = 1) uniform writeonly image2DArray slopes;          // sx, sz, Dxx, Dzz

void main() {
  int z = int(gl_WorkGroupID.x), cascade = int(gl_WorkGroupID.y);
  for (int item = int(gl_LocalInvocationIndex); item < kFields * RADIX_B; item += kThreads) {
    int field = item / RADIX_B, n2 = item % RADIX_B;
    int row = ((cascade * kFields + field) * kPoints + z) * kStored;
#define LOAD(n1) v[n1] = work[row + stored(RADIX_B * (n1) + n2)];
    EACH_OUTER_A(LOAD)
    first_step(field, n2);
  }
  barrier();
  for (int item = int(gl_LocalInvocationIndex); item < kFields * RADIX_A; item += kThreads) {
    int field = item / RADIX_A, k1 = item % RADIX_A;
    second_step(field, k1);
    // Into the same places of the exchange that this item has just read.
#define STORE(k2) exchange[(field * RADIX_A + k1) * kPitch + (k2)] = v[SLOT_B(k2)];
    EACH_B(STORE)
  }
  barrier();
  float scale = grids[cascade].w;
  for (int x = int(gl_LocalInvocationIndex); x < kPoints; x += kThreads) {
    int place = (x % RADIX_A) * kPitch + x / RADIX_A;
    const int field = RADIX_A * kPitch;
    ivec3 texel = ivec3(x, z, cascade);
    vec2 sideways = exchange[place], height = exchange[field + place];
    imageStore(displacement, texel, vec4(sideways.x, height.x, sideways.y, height.y / scale));
    imageStore(slopes, texel, vec4(exchange[2 * field + place], exchange[3 * field + place]));
  }
}
