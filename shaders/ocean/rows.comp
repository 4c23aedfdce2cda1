// The second half of the transform, along x, and the points of the maps. A group takes kLines rows of
// a cascade. Results go to buffers that are copied into the textures: stores to images cost a CPU
// renderer several times as much.
#include "ocean/fft.glsl"
layout(local_size_x = kThreads) in;

layout(std430, binding = 2) readonly buffer Work { dvec2 work[]; };  // [cascade][pair][z][stored x]
layout(std430, binding = 3) readonly buffer Grids { vec4 grids[]; };  // w: scale S of Dxz
// [cascade][z][x]: Dx, h, Dz, Dxz; sx, sz, Dxx, Dzz.
layout(std430, binding = 4) writeonly buffer Displacement { dvec2 displacement[]; };
#ifdef HALF_SLOPES
layout(std430, binding = 5) writeonly buffer Slopes { uvec2 slopes[]; };
#else
layout(std430, binding = 5) writeonly buffer Slopes { dvec2 slopes[]; };
#endif

void main() {
  int cascade = int(gl_WorkGroupID.y), thread = int(gl_LocalInvocationIndex);
  int line = thread / kTeam, mate = thread % kTeam;
  int z = int(gl_WorkGroupID.x) * kLines + line;
  for (int n2 = mate; n2 < RADIX_B; n2 += kTeam) {
    twiddle_powers(n2);
    for (int pair = 0; pair < kPairs; ++pair) {
      int row = ((cascade * kPairs + pair) * kPoints + z) * kStored;
#define LOAD(n1) v[n1] = floats(work[row + stored(RADIX_B * (n1) + n2)]);
      EACH_OUTER_A(LOAD)
#undef LOAD
      first_step(exchange_space(line, pair), n2);
    }
  }
  barrier();
  vec4 scale = vec4(1.0, 1.0, 1.0, 1.0 / grids[cascade].w);
  for (int k1 = mate; k1 < RADIX_A; k1 += kTeam) {
    int point = (cascade * kPoints + z) * kPoints + k1;
    second_step(exchange_space(line, 0), k1);
#define STORE(k2) displacement[point + RADIX_A * (k2)] = words(scale * v[SLOT_B(k2)]);
    EACH_B(STORE)
#undef STORE
    second_step(exchange_space(line, 1), k1);
#ifdef HALF_SLOPES
#define HALVES(a) uvec2(packHalf2x16(a.xy), packHalf2x16(a.zw))
#define STORE(k2) slopes[point + RADIX_A * (k2)] = HALVES(v[SLOT_B(k2)]);
#else
#define STORE(k2) slopes[point + RADIX_A * (k2)] = words(v[SLOT_B(k2)]);
#endif
    EACH_B(STORE)
#undef STORE
  }
}
