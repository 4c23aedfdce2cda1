// The second half of the transform, along x, into a buffer that is read back: eight floats a point,
// Dx, h, Dz, 0 and their rates of change. A group takes kLines rows of a cascade.
#include "ocean/fft_rows.glsl"

layout(std430, binding = 0) writeonly buffer Points { float points[]; };  // [cascade][z][x][8]

void finish(int point, int line, int k1) {
  point += 8 * k1;
  second_step(exchange_space(line, 0), k1);  // Dx, Dz, h, dh/dt
#define STORE(k2) { \
  int at = point + 8 * RADIX_A * (k2); \
  vec4 a = v[SLOT_B(k2)]; \
  points[at] = a.x; \
  points[at + 2] = a.y; \
  points[at + 1] = a.z; \
  points[at + 5] = a.w; \
  }
  EACH_B(STORE)
#undef STORE
  second_step(exchange_space(line, 1), k1);  // dDx/dt, dDz/dt
#define STORE(k2) { \
  int at = point + 8 * RADIX_A * (k2); \
  points[at + 4] = v[SLOT_B(k2)].x; \
  points[at + 6] = v[SLOT_B(k2)].y; \
  }
  EACH_B(STORE)
#undef STORE
}

void main() {
  int cascade = int(gl_WorkGroupID.y), thread = int(gl_LocalInvocationIndex);
  int line = thread / kTeam, mate = thread % kTeam;
  int z = int(gl_WorkGroupID.x) * kLines + line;
  load_rows(cascade, z, line, mate);
  int point = 8 * (cascade * kPoints + z) * kPoints;
  finish(point, line, mate);
  if (kTwice) finish(point, line, mate + kTeam);
}
