// The first step of the transform along x, whatever becomes of its points. A group takes kLines rows of a
// cascade.
#include "ocean/fft.glsl"
layout(local_size_x = kThreads) in;

layout(std430, binding = 2) readonly buffer Work { vec4 work[]; };  // [cascade][pair][z][stored x]

void load_row(int pair, int cascade, int z, int line, int n2) {
  int row = ((cascade * kPairs + pair) * kPoints + z) * kStored;
#define LOAD(n1) v[n1] = work[row + stored(RADIX_B * (n1) + n2)];
  EACH_OUTER_A(LOAD)
#undef LOAD
  first_step(exchange_space(line, pair), n2);
}
void load_rows(int cascade, int z, int line, int n2) {
  twiddle_powers(n2);
  load_row(0, cascade, z, line, n2);
  load_row(1, cascade, z, line, n2);
  barrier();
}
