// The second half of the transform, along x, and the points of the maps. A group takes kLines rows of
// a cascade. Results go to buffers that are copied into the textures: stores to images cost a CPU
// renderer several times as much.
#include "ocean/fft_rows.glsl"

layout(std430, binding = 3) readonly buffer Grids { vec4 grids[]; };  // w: scale S of Dxz
// [cascade][z][x]: Dx, h, Dz, Dxz; sx, sz, Dxx, Dzz.
layout(std430, binding = 4) writeonly buffer Displacement { vec4 displacement[]; };
#ifdef HALF_SLOPES
layout(std430, binding = 5) writeonly buffer Slopes { uvec2 slopes[]; };
#else
layout(std430, binding = 5) writeonly buffer Slopes { vec4 slopes[]; };
#endif

void finish(int point, int line, int k1, vec4 scale) {
  point += k1;
  second_step(exchange_space(line, 0), k1);
#define STORE(k2) displacement[point + RADIX_A * (k2)] = scale * v[SLOT_B(k2)];
  EACH_B(STORE)
#undef STORE
  second_step(exchange_space(line, 1), k1);
#ifdef HALF_SLOPES
#define HALVES(a) uvec2(packHalf2x16(a.xy), packHalf2x16(a.zw))
#define STORE(k2) slopes[point + RADIX_A * (k2)] = HALVES(v[SLOT_B(k2)]);
#else
#define STORE(k2) slopes[point + RADIX_A * (k2)] = v[SLOT_B(k2)];
#endif
  EACH_B(STORE)
#undef STORE
}

void main() {
  int cascade = int(gl_WorkGroupID.y), thread = int(gl_LocalInvocationIndex);
  int line = thread / kTeam, mate = thread % kTeam;
  int z = int(gl_WorkGroupID.x) * kLines + line;
  load_rows(cascade, z, line, mate);
  vec4 scale = vec4(1.0, 1.0, 1.0, 1.0 / grids[cascade].w);
  int point = (cascade * kPoints + z) * kPoints;
  finish(point, line, mate, scale);
  if (kTwice) finish(point, line, mate + kTeam, scale);
}
