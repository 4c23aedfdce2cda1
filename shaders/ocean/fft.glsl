// An inverse transform of N = RADIX_A * RADIX_B complex numbers in two steps of one thread's work
// each (Cooley & Tukey 1965): with n = B n1 + n2 and k = k1 + A k2,
//   X[k] = sum_n2 W_B^(n2 k2) W_N^(n2 k1) ( sum_n1 W_A^(n1 k1) x[n] ),   W_M = exp(+2 pi i / M).
// A thread holds a whole short transform in registers and does its part of all fields, one after the
// other; the one exchange between the steps goes through shared memory. Only indices |n| < N/4 carry
// waves (the bands end at four points per wave), so the first step knows half of its inputs to be
// zero. Memory is touched as little as can be: on a CPU renderer every lane's access is one of its
// own, whatever its width. So two fields are transformed side by side, as the halves of a vec4. Nor are
// there loops, in which it would ask of every lane whether it is still at work.
const int kPoints = RADIX_A * RADIX_B;
const int kPairs = 2;       // of complex fields; of three the last half is empty
const int kTeam = RADIX_B;  // threads that share a line: each does one transform of the first step …
const bool kTwice = RADIX_A > RADIX_B;  // … and one or two of the second
const int kLines = kPoints > 256 ? 1 : 32 / kTeam;        // lines of a group: as memory allows
const int kThreads = kTeam * kLines;
const int kStored = kPoints / 2;  // indices with waves: 0 … N/4-1, then 3N/4 … N-1
const int kPitch = RADIX_B + 1;   // one column more than needed keeps the banks apart

layout(std430, binding = 1) readonly buffer Twiddles { vec2 twiddles[]; };  // W_N^j, from double
shared vec4 exchange[kLines * kPairs * RADIX_A * kPitch];

vec4 v[RADIX_A > RADIX_B ? RADIX_A : RADIX_B];

// Written-out loops: v[] must only see constant indices, or it does not stay in registers.
#define EACH_4(f, o) f(o) f(o + 1) f(o + 2) f(o + 3)
#define EACH_8(f, o) EACH_4(f, o) EACH_4(f, o + 4)
#define EACH_16(f, o) EACH_8(f, o) EACH_8(f, o + 8)
#if RADIX_A == 8
#define EACH_A(f) EACH_8(f, 0)
#define EACH_OUTER_A(f) f(0) f(1) f(6) f(7)
#define EACH_INNER_A(f) EACH_4(f, 2)
#elif RADIX_A == 16
#define EACH_A(f) EACH_16(f, 0)
#define EACH_OUTER_A(f) EACH_4(f, 0) EACH_4(f, 12)
#define EACH_INNER_A(f) EACH_8(f, 4)
#else
#define EACH_A(f) EACH_16(f, 0) EACH_16(f, 16)
#define EACH_OUTER_A(f) EACH_8(f, 0) EACH_8(f, 24)
#define EACH_INNER_A(f) EACH_16(f, 8)
#endif
#if RADIX_B == 8
#define EACH_B(f) EACH_8(f, 0)
#else
#define EACH_B(f) EACH_16(f, 0)
#endif

vec2 times(vec2 a, vec2 b) { return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x); }
vec2 times_i(vec2 a) { return vec2(-a.y, a.x); }
// Both of a pair.
vec4 times(vec4 a, vec2 b) { return a * b.x + vec4(-a.y, a.x, -a.w, a.z) * b.y; }
vec4 times_i(vec4 a) { return vec4(-a.y, a.x, -a.w, a.z); }

void dft4(int a, int b, int c, int d) {
  vec4 s = v[a] + v[c], t = v[a] - v[c], p = v[b] + v[d], q = times_i(v[b] - v[d]);
  v[a] = s + p;
  v[b] = t + q;
  v[c] = s - p;
  v[d] = t - q;
}

const float kC1 = 0.92387953251128674;  // cos(pi/8)
const float kS1 = 0.38268343236508977;
const float kH = 0.70710678118654752;
vec4 w16_1(vec4 a) { return times(a, vec2(kC1, kS1)); }
vec4 w16_2(vec4 a) { return kH * (a + times_i(a)); }
vec4 w16_3(vec4 a) { return times(a, vec2(kS1, kC1)); }
vec4 w16_6(vec4 a) { return kH * (times_i(a) - a); }
vec4 w16_9(vec4 a) { return times(a, vec2(-kC1, -kS1)); }

// Results lie in v[] at slot16(k), slot8(k), slot32(k).
void dft8() {
#define STEP(n) { vec4 a = v[n], b = v[n + 4]; v[n] = a + b; v[n + 4] = a - b; }
  EACH_4(STEP, 0)
#undef STEP
  v[5] = w16_2(v[5]);
  v[6] = times_i(v[6]);
  v[7] = w16_6(v[7]);
  dft4(0, 1, 2, 3);
  dft4(4, 5, 6, 7);
}
int slot8(int k) { return 4 * (k & 1) + (k >> 1); }

#if RADIX_A >= 16 || RADIX_B >= 16
void dft16(int o) {
  dft4(o + 0, o + 4, o + 8, o + 12);
  dft4(o + 1, o + 5, o + 9, o + 13);
  dft4(o + 2, o + 6, o + 10, o + 14);
  dft4(o + 3, o + 7, o + 11, o + 15);
  v[o + 5] = w16_1(v[o + 5]);
  v[o + 6] = w16_2(v[o + 6]);
  v[o + 7] = w16_3(v[o + 7]);
  v[o + 9] = w16_2(v[o + 9]);
  v[o + 10] = times_i(v[o + 10]);
  v[o + 11] = w16_6(v[o + 11]);
  v[o + 13] = w16_3(v[o + 13]);
  v[o + 14] = w16_6(v[o + 14]);
  v[o + 15] = w16_9(v[o + 15]);
  dft4(o + 0, o + 1, o + 2, o + 3);
  dft4(o + 4, o + 5, o + 6, o + 7);
  dft4(o + 8, o + 9, o + 10, o + 11);
  dft4(o + 12, o + 13, o + 14, o + 15);
}
#endif
int slot16(int k) { return 4 * (k & 3) + (k >> 2); }

#if RADIX_A >= 32
void dft32() {
  const vec2 w32[16] = vec2[16](
      vec2(1.0, 0.0), vec2(0.98078528040323043, 0.19509032201612825), vec2(kC1, kS1),
      vec2(0.83146961230254524, 0.55557023301960218), vec2(kH, kH),
      vec2(0.55557023301960229, 0.83146961230254524), vec2(kS1, kC1),
      vec2(0.19509032201612833, 0.98078528040323043), vec2(0.0, 1.0),
      vec2(-0.19509032201612819, 0.98078528040323043), vec2(-kS1, kC1),
      vec2(-0.55557023301960196, 0.83146961230254546), vec2(-kH, kH),
      vec2(-0.83146961230254535, 0.55557023301960218), vec2(-kC1, kS1),
      vec2(-0.98078528040323043, 0.19509032201612861));
#define STEP(n) \
  { vec4 a = v[n], b = v[n + 16]; v[n] = a + b; v[n + 16] = times(a - b, w32[n]); }
  EACH_16(STEP, 0)
#undef STEP
  dft16(0);
  dft16(16);
}
#endif
int slot32(int k) { return 16 * (k & 1) + slot16(k >> 1); }

#if RADIX_A == 8
#define DFT_A() dft8()
#define SLOT_A slot8
#elif RADIX_A == 16
#define DFT_A() dft16(0)
#define SLOT_A slot16
#else
#define DFT_A() dft32()
#define SLOT_A slot32
#endif
#if RADIX_B == 8
#define DFT_B() dft8()
#define SLOT_B slot8
#else
#define DFT_B() dft16(0)
#define SLOT_B slot16
#endif

// The two steps around the exchange, for one of the group's lines and a pair of fields: `space` is
// their place in it. A caller loads v[n1], n1 outside [A/4, 3A/4), for its n2, and takes X[k1 + A k2] from
// v[SLOT_B(k2)] for its k1.
int exchange_space(int line, int pair) { return (line * kPairs + pair) * RADIX_A * kPitch; }

// Powers of one root by products of three at most: rounding grows little, and one load does.
vec2 w[RADIX_A];
void twiddle_powers(int n2) {
  w[1] = twiddles[n2];
#define SQUARE(n) w[2 * (n)] = times(w[n], w[n]); w[2 * (n) + 1] = times(w[2 * (n)], w[1]);
  SQUARE(1) SQUARE(2) SQUARE(3)
#if RADIX_A >= 16
  EACH_4(SQUARE, 4)
#endif
#if RADIX_A >= 32
  EACH_8(SQUARE, 8)
#endif
#undef SQUARE
}
void first_step(int space, int n2) {
#define CLEAR(n1) v[n1] = vec4(0.0);
#define STORE(k1) exchange[space + (k1) * kPitch + n2] = times(v[SLOT_A(k1)], w[k1]);
  EACH_INNER_A(CLEAR)
  DFT_A();
  w[0] = vec2(1.0, 0.0);
  EACH_A(STORE)
#undef CLEAR
#undef STORE
}
void second_step(int space, int k1) {
#define LOAD(n2) v[n2] = exchange[space + k1 * kPitch + n2];
  EACH_B(LOAD)
  DFT_B();
#undef LOAD
}

// Where a grid index with waves is stored: 0 … N/4-1 and 3N/4 … N-1 side by side.
int stored(int n) { return n < kPoints / 2 ? n : n - kPoints / 2; }
