// The sea at one moment, as wave amplitudes, transformed along z. A group takes kLines columns of a
// cascade.
//   H(k, t) = h0(k) exp(-i w t) + conj(h0(-k)) exp(i w t)
// and, with displacement D = i u H, u = c coth(kh) k / |k| (c: choppiness), the real fields that are
// packed in pairs, of like size:
//   FIELDS 4, maps:     Dx + i h,  Dz + i S Dxz,  sx + i sz,  Dxx + i Dzz   (Dxz = dDx/dz, sx = dh/dx)
//   FIELDS 3, moments:  Dx + i Dz,  h + i dh/dt,  dDx/dt + i dDz/dt
#include "lib/waves.glsl"
#include "ocean/fft.glsl"
layout(local_size_x = kThreads) in;

// h0 real, imaginary; frequency in turns per second as the sum of two floats. [cascade][x][z]
layout(std430, binding = 0) readonly buffer Modes { vec4 modes[]; };
layout(std430, binding = 2) writeonly buffer Work { vec4 work[]; };  // [cascade][pair][z][stored x]
layout(std430, binding = 3) readonly buffer Grids { vec4 grids[]; };  // dk cos, dk sin, c, S
layout(location = 0) uniform ivec2 time_bits;  // the sea's clock, a double

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

// A column's waves at a thread's own indices.
const int kOwn = RADIX_A / 2;
vec2 own_h[kOwn], own_k[kOwn], own_u[kOwn];
#if FIELDS == 3
vec2 own_rate[kOwn];
#endif

// What the transform of a field has at one of them.
vec2 field_amplitude(int field, float shear, int own) {
  vec2 h = own_h[own], k = own_k[own], u = own_u[own];
#if FIELDS == 4
  return field == 0 ? (1.0 + u.x) * times_i(h)
       : field == 1 ? (u.y - shear * k.y * u.x) * times_i(h)
       : field == 2 ? times(vec2(-k.y, k.x), h)
                    : times(vec2(-k.x * u.x, -k.y * u.y), h);
#else
  vec2 rate = own_rate[own];
  return field == 0 ? times(vec2(-u.y, u.x), h)
       : field == 1 ? h + times_i(rate)
       : field == 2 ? times(vec2(-u.y, u.x), rate)
                    : vec2(0.0);
#endif
}

vec4 pair_amplitude(int pair, float shear, int own) {
  return vec4(field_amplitude(2 * pair, shear, own), field_amplitude(2 * pair + 1, shear, own));
}

void transform_own(int pair, float shear, int space, int n2) {
#define LOAD(n1) v[n1] = pair_amplitude(pair, shear, (n1) < kOwn ? (n1) : (n1) - kOwn);
  EACH_OUTER_A(LOAD)
#undef LOAD
  first_step(space, n2);
}

// `place`: of a pair's column in the buffer.
void finish(int place, int space, int k1) {
  second_step(space, k1);
#define STORE(k2) work[place + (k1 + RADIX_A * (k2)) * kStored] = v[SLOT_B(k2)];
  EACH_B(STORE)
#undef STORE
}

// The wave at index n1 RADIX_B + n2 of column x, now.
#define EVOLVE(n1) evolve((n1) < kOwn ? (n1) : (n1) - kOwn, cascade, x, RADIX_B * (n1) + n2, grid, time);
void evolve(int own, int cascade, int x, int z, vec4 grid, double time) {
  int base = cascade * kPoints * kPoints;
  int mirrored_x = (kPoints - x) & (kPoints - 1), mirrored_z = (kPoints - z) & (kPoints - 1);
  vec4 mode = modes[base + x * kPoints + z];
  vec4 mirrored = modes[base + mirrored_x * kPoints + mirrored_z];
  vec2 p = unit_phase((double(mode.z) + double(mode.w)) * time);
  vec2 a = times(mode.xy, vec2(p.x, -p.y)), b = times(vec2(mirrored.x, -mirrored.y), p);
  float w = 2.0 * kWavePi * mode.z;
  vec2 indices = vec2(x < kPoints / 2 ? x : x - kPoints, z < kPoints / 2 ? z : z - kPoints);
  float k = length(grid.xy) * length(indices);
  own_h[own] = a + b;
  own_k[own] = vec2(grid.x * indices.x - grid.y * indices.y, grid.y * indices.x + grid.x * indices.y);
  own_u[own] = grid.z * wave_sideways(k, w) / max(k, 1.0e-10) * own_k[own];
#if FIELDS == 3
  own_rate[own] = w * vec2(a.y - b.y, b.x - a.x);  // -i w (a - b)
#endif
}

void main() {
  int cascade = int(gl_WorkGroupID.y), thread = int(gl_LocalInvocationIndex);
  int line = thread / kTeam, n2 = thread % kTeam;
  int column = int(gl_WorkGroupID.x) * kLines + line;
  int x = column < kPoints / 4 ? column : column + kPoints / 2;
  vec4 grid = grids[cascade];
  double time = packDouble2x32(uvec2(time_bits));
  EACH_OUTER_A(EVOLVE)
  twiddle_powers(n2);
  transform_own(0, grid.w, exchange_space(line, 0), n2);
  transform_own(1, grid.w, exchange_space(line, 1), n2);
  barrier();
  int place = cascade * kPairs * kPoints * kStored + column;
  finish(place, exchange_space(line, 0), n2);
  if (kTwice) finish(place, exchange_space(line, 0), n2 + kTeam);
  place += kPoints * kStored;
  finish(place, exchange_space(line, 1), n2);
  if (kTwice) finish(place, exchange_space(line, 1), n2 + kTeam);
}
