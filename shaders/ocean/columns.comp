// The sea at one moment, as wave amplitudes, transformed along z. One group per column and cascade.
//   H(k, t) = h0(k) exp(-i w t) + conj(h0(-k)) exp(i w t)
// and, with displacement D = i u H, u = c coth(kh) k / |k| (c: choppiness), the real fields that are
// packed in pairs, of like size:
//   FIELDS 4, maps:     Dx + i Dz,  h + i S Dxz,  sx + i sz,  Dxx + i Dzz   (Dxz = dDx/dz, sx = dh/dx)
//   FIELDS 3, moments:  Dx + i Dz,  h + i dh/dt,  dDx/dt + i dDz/dt
#include "lib/waves.glsl"
#include "ocean/fft.glsl"
layout(local_size_x = kThreads) in;

// h0 real, imaginary; frequency in turns per second as the sum of two floats. [cascade][x][z]
layout(std430, binding = 0) readonly buffer Modes { vec4 modes[]; };
layout(std430, binding = 2) writeonly buffer Work { vec2 work[]; };  // [cascade][field][z][stored x]
layout(std430, binding = 3) readonly buffer Grids { vec4 grids[]; };  // dk cos, dk sin, c, S
layout(location = 0) uniform ivec2 time_bits;  // the sea's clock, a double

shared vec2 amplitude[kStored];
shared float sideways[kStored];  // |u| / |k|
#if FIELDS == 3
shared vec2 rates[kStored];
#endif

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
  int at = stored(n);
  vec2 u = sideways[at] * k;
#if FIELDS == 4
  vec2 factor = field == 0 ? vec2(-u.y, u.x)
              : field == 1 ? vec2(1.0, -grid.w * k.y * u.x)
              : field == 2 ? vec2(-k.y, k.x)
                           : vec2(-k.x * u.x, -k.y * u.y);
  return times(factor, amplitude[at]);
#else
  vec2 h = amplitude[at], rate = rates[at];
  return field == 0 ? times(vec2(-u.y, u.x), h) : field == 1 ? h + times_i(rate)
                                                : times(vec2(-u.y, u.x), rate);
#endif
}

void main() {
  int column = int(gl_WorkGroupID.x), cascade = int(gl_WorkGroupID.y);
  int x = column < kPoints / 4 ? column : column + kPoints / 2;
  int mirrored_x = (kPoints - x) & (kPoints - 1);
  int base = cascade * kPoints * kPoints;
  double time = packDouble2x32(uvec2(time_bits));

  vec4 grid = grids[cascade];
  float nx = float(x < kPoints / 2 ? x : x - kPoints);
  for (int i = int(gl_LocalInvocationIndex); i < kStored; i += kThreads) {
    int z = i < kPoints / 4 ? i : i + kPoints / 2;
    vec4 mode = modes[base + x * kPoints + z];
    vec4 mirrored = modes[base + mirrored_x * kPoints + ((kPoints - z) & (kPoints - 1))];
    vec2 p = unit_phase((double(mode.z) + double(mode.w)) * time);
    vec2 a = times(mode.xy, vec2(p.x, -p.y)), b = times(vec2(mirrored.x, -mirrored.y), p);
    float w = 2.0 * kWavePi * mode.z;
    float nz = float(z < kPoints / 2 ? z : z - kPoints);
    float k = length(grid.xy) * sqrt(nx * nx + nz * nz);
    amplitude[i] = a + b;
    sideways[i] = grid.z * wave_sideways(k, w) / max(k, 1.0e-10);
#if FIELDS == 3
    rates[i] = w * vec2(a.y - b.y, b.x - a.x);  // -i w (a - b)
#endif
  }
  barrier();

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
