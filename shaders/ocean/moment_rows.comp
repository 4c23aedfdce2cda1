// The second half of the transform, along x, into a buffer that is read back: eight floats a point,
// Dx, h, Dz, 0 and their rates of change. A group takes kLines rows of a cascade.
#include "ocean/fft.glsl"
layout(local_size_x = kThreads) in;

layout(std430, binding = 0) writeonly buffer Points { float points[]; };  // [cascade][z][x][8]
layout(std430, binding = 2) readonly buffer Work { double work[]; };  // [cascade][field][z][stored x]

void main() {
  int cascade = int(gl_WorkGroupID.y), thread = int(gl_LocalInvocationIndex);
  int line = thread / kTeam, mate = thread % kTeam;
  int z = int(gl_WorkGroupID.x) * kLines + line;
  for (int n2 = mate; n2 < RADIX_B; n2 += kTeam) {
    twiddle_powers(n2);
    for (int field = 0; field < kFields; ++field) {
      int row = ((cascade * kFields + field) * kPoints + z) * kStored;
#define LOAD(n1) v[n1] = two_floats(work[row + stored(RADIX_B * (n1) + n2)]);
      EACH_OUTER_A(LOAD)
#undef LOAD
      first_step(exchange_space(line, field), n2);
    }
  }
  barrier();
  for (int k1 = mate; k1 < RADIX_A; k1 += kTeam) {
    int point = 8 * ((cascade * kPoints + z) * kPoints + k1);
    // Dx + i Dz, h + i dh/dt, dDx/dt + i dDz/dt
    for (int field = 0; field < kFields; ++field) {
      second_step(exchange_space(line, field), k1);
      int real = point + (field == 0 ? 0 : field == 1 ? 1 : 4);
      int imaginary = point + (field == 0 ? 2 : field == 1 ? 5 : 6);
#define STORE(k2) \
  points[real + 8 * RADIX_A * (k2)] = v[SLOT_B(k2)].x; \
  points[imaginary + 8 * RADIX_A * (k2)] = v[SLOT_B(k2)].y;
      EACH_B(STORE)
#undef STORE
    }
  }
}
