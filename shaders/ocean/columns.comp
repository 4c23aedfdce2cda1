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
layout(std430, binding = 2) writeonly buffer Work { dvec2 work[]; };  // [cascade][pair][z][stored x]
layout(std430, binding = 3) readonly buffer Grids { vec4 grids[]; };  // dk cos, dk sin, c, S
layout(location = 0) uniform ivec2 time_bits;  // the sea's clock, a double

shared dvec2 waves[kLines * kStored];  // amplitude; |u| / |k| and nothing
#if FIELDS == 3
shared vec2 rates[kLines * kStored];
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

void main() {
  int cascade = int(gl_WorkGroupID.y), thread = int(gl_LocalInvocationIndex);
  int base = cascade * kPoints * kPoints;
  double time = packDouble2x32(uvec2(time_bits));
  vec4 grid = grids[cascade];

  for (int i = thread; i < kLines * kStored; i += kThreads) {
    int column = int(gl_WorkGroupID.x) * kLines + i / kStored, n = i % kStored;
    int x = column < kPoints / 4 ? column : column + kPoints / 2;
    int z = n < kPoints / 4 ? n : n + kPoints / 2;
    int mirrored_x = (kPoints - x) & (kPoints - 1), mirrored_z = (kPoints - z) & (kPoints - 1);
    vec4 mode = modes[base + x * kPoints + z];
    vec4 mirrored = modes[base + mirrored_x * kPoints + mirrored_z];
    vec2 p = unit_phase((double(mode.z) + double(mode.w)) * time);
    vec2 a = times(mode.xy, vec2(p.x, -p.y)), b = times(vec2(mirrored.x, -mirrored.y), p);
    float w = 2.0 * kWavePi * mode.z;
    vec2 indices = vec2(x < kPoints / 2 ? x : x - kPoints, z < kPoints / 2 ? z : z - kPoints);
    float k = length(grid.xy) * length(indices);
    waves[i] = words(vec4(a + b, grid.z * wave_sideways(k, w) / max(k, 1.0e-10), 0.0));
#if FIELDS == 3
    rates[i] = w * vec2(a.y - b.y, b.x - a.x);  // -i w (a - b)
#endif
  }
  barrier();

  int line = thread / kTeam, mate = thread % kTeam;
  int column = int(gl_WorkGroupID.x) * kLines + line;
  float nx = float(column < kPoints / 4 ? column : column - kPoints / 2);
  for (int n2 = mate; n2 < RADIX_B; n2 += kTeam) {
    twiddle_powers(n2);
#define OWN(n1) \
  { \
    int n = RADIX_B * (n1) + n2, at = line * kStored + stored(n); \
    const int own = (n1) < kOwn ? (n1) : (n1) - kOwn; \
    float nz = float(n < kPoints / 2 ? n : n - kPoints); \
    own_k[own] = vec2(grid.x * nx - grid.y * nz, grid.y * nx + grid.x * nz); \
    vec4 wave = floats(waves[at]); \
    own_h[own] = wave.xy; \
    own_u[own] = wave.z * own_k[own]; \
    OWN_RATE \
  }
#if FIELDS == 3
#define OWN_RATE own_rate[own] = rates[at];
#else
#define OWN_RATE
#endif
    EACH_OUTER_A(OWN)
    for (int pair = 0; pair < kPairs; ++pair) {
#define LOAD(n1) v[n1] = pair_amplitude(pair, grid.w, (n1) < kOwn ? (n1) : (n1) - kOwn);
      EACH_OUTER_A(LOAD)
#undef LOAD
      first_step(exchange_space(line, pair), n2);
    }
  }
  barrier();
  for (int k1 = mate; k1 < RADIX_A; k1 += kTeam) {
    for (int pair = 0; pair < kPairs; ++pair) {
      second_step(exchange_space(line, pair), k1);
      int place = (cascade * kPairs + pair) * kPoints * kStored + column;
#define STORE(k2) work[place + (k1 + RADIX_A * (k2)) * kStored] = words(v[SLOT_B(k2)]);
      EACH_B(STORE)
#undef STORE
    }
  }
}
