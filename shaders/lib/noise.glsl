// Gradient noise in three dimensions with its gradient. Compiled as GLSL and as double-precision C++.
// K. Perlin, "Improving Noise", SIGGRAPH 2002: a quintic fade between the corners of a cell, and twelve
// gradients toward the middles of a cube's edges (four of them twice, to make sixteen).

// The lattice's own random number. Perlin's permutation table repeats after 256 cells; an integer hash
// needs no table (constants of PCG's output step and of MurmurHash3's finaliser).
uint noise_hash(int x, int y, int z) {
  uint h = uint(x) * 0x9e3779b1u ^ uint(y) * 0x85ebca77u ^ uint(z) * 0xc2b2ae3du;
  h = (h ^ (h >> 16)) * 0x85ebca6bu;
  h = (h ^ (h >> 13)) * 0xc2b2ae35u;
  return h ^ (h >> 16);
}

// One of the sixteen gradients, of length sqrt(2).
vec3 noise_lattice_gradient(int x, int y, int z) {
  uint h = noise_hash(x, y, z) & 15u;
  float a = (h & 1u) == 0u ? 1.0 : -1.0;
  float b = (h & 2u) == 0u ? 1.0 : -1.0;
  if (h < 4u || h == 12u || h == 13u) return vec3(a, h < 4u ? b : 1.0, 0.0);
  if (h < 8u) return vec3(a, 0.0, b);
  return vec3(0.0, h < 12u ? a : -1.0, h < 12u ? b : a);
}

float noise_fade(float t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); }
float noise_fade_slope(float t) { return 30.0 * t * t * (t - 1.0) * (t - 1.0); }

struct Noise {
  float value;    // 0 at every lattice point, mean 0, within about -1 … 1
  vec3 gradient;  // of the value, with respect to the point
};

Noise gradient_noise(vec3 p) {
  float fx = floor(p.x);
  float fy = floor(p.y);
  float fz = floor(p.z);
  int x = int(fx);
  int y = int(fy);
  int z = int(fz);
  vec3 t = p - vec3(fx, fy, fz);
  vec3 w = vec3(noise_fade(t.x), noise_fade(t.y), noise_fade(t.z));
  vec3 dw = vec3(noise_fade_slope(t.x), noise_fade_slope(t.y), noise_fade_slope(t.z));
  Noise sum;
  sum.value = 0.0;
  sum.gradient = vec3(0.0, 0.0, 0.0);
  for (int corner = 0; corner < 8; ++corner) {
    int i = corner & 1;
    int j = (corner >> 1) & 1;
    int k = corner >> 2;
    vec3 g = noise_lattice_gradient(x + i, y + j, z + k);
    float ramp = dot(g, t - vec3(float(i), float(j), float(k)));
    // The corner's share of the trilinear blend, and how it changes along each axis.
    float a = i == 1 ? w.x : 1.0 - w.x;
    float b = j == 1 ? w.y : 1.0 - w.y;
    float c = k == 1 ? w.z : 1.0 - w.z;
    float da = i == 1 ? dw.x : -dw.x;
    float db = j == 1 ? dw.y : -dw.y;
    float dc = k == 1 ? dw.z : -dw.z;
    sum.value += a * b * c * ramp;
    sum.gradient += a * b * c * g + ramp * vec3(da * b * c, a * db * c, a * b * dc);
  }
  return sum;
}
