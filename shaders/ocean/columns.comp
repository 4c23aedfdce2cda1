// The sea at one moment, as wave amplitudes, transformed along z. One group per column and cascade.
//   H(k, t) = h0(k) exp(-i w t) + conj(h0(-k)) exp(i w t)
// and, with displacement D = i (k/|k|) c H (c: choppiness), the eight fields packed in pairs:
//   Dx + i h,  Dz + i Dxz,  sx + i sz,  Dxx + i Dzz      (Dxz = dDx/dz, sx = dh/dx, …)
#include "shared/ocean.h"
#include "ocean/fft.glsl"
layout(local_size_x = kThreads) in;

// h0 real, imaginary; frequency in turns per second as the sum of two floats. [cascade][x][z]
layout(std430, binding = 0) readonly buffer Modes { vec4 modes[]; };
layout(std430, binding = 2) writeonly buffer Work { vec2 work[]; };  // [cascade][field][z][stored x]
layout(std430, binding = 3) readonly buffer Grids { vec4 grids[]; };  // dk cos, dk sin, choppiness
layout(location = 0) uniform ivec2 time_bits;  // the sea's clock, a double

shared vec2 amplitude[kStored];

// (cos, sin) of 2 pi turns. The whole turns are taken off in double, so that a month of seconds
// loses nothing; then at most an eighth of a turn is left for the series (error below 2e-9).
vec2 unit_phase(double turns) {
  double part = turns - floor(turns);
  int quarter = int(4.0 * float(part) + 0.5);
  float a = float(part - 0.25lf * double(quarter)) * 6.28318530717958648;
  float b = a * a;
  float s = a * (1.0 + b * (-1.6666666666e-1 + b * (8.3333333333e-3 +
            b * (-1.9841269841e-4 + b * 2.7557319224e-6))));
  float c = 1.0 + b * (-0.5 + b * (4.1666666666e-2 + b * (-1.3888888889e-3 + b * 2.4801587302e-5)));
  vec2 p = vec2(c, s);
  if ((quarter & 1) != 0) p = vec2(-p.y, p.x);
  return (quarter & 2) != 0 ? -p : p;
}

// What the transform of a field has at index n of this column.
vec2 field_amplitude(int field, vec4 grid, float nx, int n) {
  float nz = float(n < kPoints / 2 ? n : n - kPoints);
  vec2 k = vec2(grid.x * nx - grid.y * nz, grid.y * nx + grid.x * nz);
  vec2 u = grid.z * k * inversesqrt(max(dot(k, k), 1.0e-20));
  vec2 factor = field == 0 ? vec2(0.0, 1.0 + u.x)
              : field == 1 ? vec2(0.0, u.y * (1.0 - k.x))
              : field == 2 ? vec2(-k.y, k.x)
                           : vec2(-k.x * u.x, -k.y * u.y);
  return times(factor, amplitude[stored(n)]);
}

void main() {
  int column = int(gl_WorkGroupID.x), cascade = int(gl_WorkGroupID.y);
  int x = column < kPoints / 4 ? column : column + kPoints / 2;
  int mirrored_x = (kPoints - x) & (kPoints - 1);
  int base = cascade * kPoints * kPoints;
  double time = packDouble2x32(uvec2(time_bits));

  for (int i = int(gl_LocalInvocationIndex); i < kStored; i += kThreads) {
    int z = i < kPoints / 4 ? i : i + kPoints / 2;
    vec4 mode = modes[base + x * kPoints + z];
    vec4 mirrored = modes[base + mirrored_x * kPoints + ((kPoints - z) & (kPoints - 1))];
    vec2 p = unit_phase((double(mode.z) + double(mode.w)) * time);
    // h0 conj(p) + conj(h0m) p
    amplitude[i] = vec2((mode.x + mirrored.x) * p.x + (mode.y + mirrored.y) * p.y,
                        (mode.y - mirrored.y) * p.x - (mode.x - mirrored.x) * p.y);
  }
  barrier();

  vec4 grid = grids[cascade];
  float nx = float(x < kPoints / 2 ? x : x - kPoints);
  for (int item = int(gl_LocalInvocationIndex); item < kFields * RADIX_B; item += kThreads) {
    int field = item / RADIX_B, n2 = item % RADIX_B;
#define LOAD(n1) v[n1] = field_amplitude(field, grid, nx, RADIX_B * (n1) + n2);
    EACH_OUTER_A(LOAD)
#undef LOAD
    first_step(field, n2);
  }
  barrier();
  for (int item = int(gl_LocalInvocationIndex); item < kFields * RADIX_A; item += kThreads) {
    int field = item / RADIX_A, k1 = item % RADIX_A;
    second_step(field, k1);
    int place = (cascade * kFields + field) * kPoints * kStored + column;
#define STORE(k2) work[place + (k1 + RADIX_A * (k2)) * kStored] = v[SLOT_B(k2)];
    EACH_B(STORE)
  }
}
