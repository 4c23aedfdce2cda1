// The second half of the transform, along x, into a buffer that is read back: two vec4 a point, Dx, h,
// Dz, 0 and their rates of change. One group per row and cascade.
#include "ocean/fft.glsl"
layout(local_size_x = kThreads) in;

layout(std430, binding = 0) writeonly buffer Points { vec4 points[]; };  // [cascade][z][x][2]
layout(std430, binding = 2) readonly buffer Work { vec2 work[]; };  // [cascade][field][z][stored x]

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
#define STORE(k2) exchange[(field * RADIX_A + k1) * kPitch + (k2)] = v[SLOT_B(k2)];
    EACH_B(STORE)
  }
  barrier();
  int row = (cascade * kPoints + z) * kPoints;
  for (int x = int(gl_LocalInvocationIndex); x < kPoints; x += kThreads) {
    int place = (x % RADIX_A) * kPitch + x / RADIX_A;
    const int field = RADIX_A * kPitch;
    vec2 sideways = exchange[place], height = exchange[field + place];
    vec2 drift = exchange[2 * field + place];
    points[2 * (row + x)] = vec4(sideways.x, height.x, sideways.y, 0.0);
    points[2 * (row + x) + 1] = vec4(drift.x, height.y, drift.y, 0.0);
  }
}
