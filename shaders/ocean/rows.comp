// The second half of the transform, along x, and the points of the maps. A group takes kLines rows of
// a cascade. Results go to buffers that are copied into the textures: stores to images cost a CPU
// renderer several times as much.
#include "ocean/fft.glsl"
layout(local_size_x = kThreads) in;

layout(std430, binding = 2) readonly buffer Work { double work[]; };  // [cascade][field][z][stored x]
layout(std430, binding = 3) readonly buffer Grids { vec4 grids[]; };  // w: scale S of Dxz
// [cascade][z][x], two pairs each: Dx, h and Dz, Dxz; sx, sz and Dxx, Dzz.
layout(std430, binding = 4) writeonly buffer Displacement { double displacement[]; };
#ifdef HALF_SLOPES
layout(std430, binding = 5) writeonly buffer Slopes { uint slopes[]; };
#else
layout(std430, binding = 5) writeonly buffer Slopes { double slopes[]; };
#endif

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
  float unscale = 1.0 / grids[cascade].w;
  for (int k1 = mate; k1 < RADIX_A; k1 += kTeam) {
    int point = (cascade * kPoints + z) * kPoints + k1;
    for (int pair = 0; pair < 2; ++pair) {
      vec2 scale = vec2(1.0, pair == 0 ? 1.0 : unscale);
      second_step(exchange_space(line, pair), k1);
#define STORE(k2) \
  displacement[2 * (point + RADIX_A * (k2)) + pair] = one_word(scale * v[SLOT_B(k2)]);
      EACH_B(STORE)
#undef STORE
    }
    for (int pair = 0; pair < 2; ++pair) {
      second_step(exchange_space(line, 2 + pair), k1);
#ifdef HALF_SLOPES
#define STORE(k2) slopes[2 * (point + RADIX_A * (k2)) + pair] = packHalf2x16(v[SLOT_B(k2)]);
#else
#define STORE(k2) slopes[2 * (point + RADIX_A * (k2)) + pair] = one_word(v[SLOT_B(k2)]);
#endif
      EACH_B(STORE)
#undef STORE
    }
  }
}
