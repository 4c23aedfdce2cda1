// Noise that repeats: gradient noise (Perlin 2002) and cellular noise (Worley 1996) over the unit cube,
// and sums of their octaves. Needs lib/noise.glsl before it.

int wrap_cell(int i, int cells) { return i - cells * int(floor(float(i) / float(cells))); }

// Perlin's noise with `cells` lattice cells along each side of the unit cube; repeats after 1.
// Mean 0, within about -1 … 1.
float tiled_gradient_noise(vec3 at, int cells, int seed) {
  vec3 p = at * float(cells);
  vec3 cell = floor(p);
  vec3 t = p - cell;
  vec3 w = vec3(noise_fade(t.x), noise_fade(t.y), noise_fade(t.z));
  float sum = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    int i = corner & 1;
    int j = (corner >> 1) & 1;
    int k = corner >> 2;
    vec3 g = noise_lattice_gradient(wrap_cell(int(cell.x) + i, cells) + 57 * seed,
                                    wrap_cell(int(cell.y) + j, cells) + 31 * seed,
                                    wrap_cell(int(cell.z) + k, cells));
    float a = i == 1 ? w.x : 1.0 - w.x;
    float b = j == 1 ? w.y : 1.0 - w.y;
    float c = k == 1 ? w.z : 1.0 - w.z;
    sum += a * b * c * dot(g, t - vec3(float(i), float(j), float(k)));
  }
  return sum;
}

// Distance to the nearest of one random point in each of `cells` cells along a side, in cells, at
// most 1; repeats after 1.
float tiled_cellular_noise(vec3 at, int cells, int seed) {
  vec3 p = at * float(cells);
  vec3 cell = floor(p);
  vec3 t = p - cell;
  float nearest = 1.0;
  for (int n = 0; n < 27; ++n) {
    int i = n % 3 - 1;
    int j = (n / 3) % 3 - 1;
    int k = n / 9 - 1;
    uint h = noise_hash(wrap_cell(int(cell.x) + i, cells) + 131 * seed,
                        wrap_cell(int(cell.y) + j, cells) + 17 * seed,
                        wrap_cell(int(cell.z) + k, cells));
    vec3 point = vec3(float(h & 1023u), float((h >> 10) & 1023u), float((h >> 20) & 1023u)) / 1024.0;
    vec3 to = vec3(float(i), float(j), float(k)) + point - t;
    nearest = min(nearest, dot(to, to));
  }
  return sqrt(nearest);
}

// What one channel of a noise volume holds.
struct NoiseChannel {
  int cells;          // of the first octave along a side
  int octaves;
  float persistence;  // an octave's strength over that of the one before
  int lacunarity;     // its cells over theirs
  float inverted;     // 1: bright inside the cells, 0: bright along their walls
};

// Octaves with cells finer than two texels would only alias: they are left out (`texels` along a side).
float octave_share(int cells, int texels) { return 2 * cells <= texels ? 1.0 : 0.0; }

// 0 … 1.
float cellular_octaves(NoiseChannel channel, vec3 at, int texels, int seed) {
  float sum = 0.0;
  float total = 0.0;
  float weight = 1.0;
  int cells = channel.cells;
  for (int octave = 0; octave < channel.octaves; ++octave) {
    float share = weight * octave_share(cells, texels);
    sum += share * tiled_cellular_noise(at, cells, seed + octave);
    total += share;
    weight *= channel.persistence;
    cells *= channel.lacunarity;
  }
  float value = total > 0.0 ? sum / total : 0.5;
  return channel.inverted > 0.5 ? 1.0 - value : value;
}

// 0 … 1, mean 1/2.
float gradient_octaves(NoiseChannel channel, vec3 at, int texels, int seed) {
  float sum = 0.0;
  float total = 0.0;
  float weight = 1.0;
  int cells = channel.cells;
  for (int octave = 0; octave < channel.octaves; ++octave) {
    float share = weight * octave_share(cells, texels);
    sum += share * tiled_gradient_noise(at, cells, seed + octave);
    total += share;
    weight *= channel.persistence;
    cells *= channel.lacunarity;
  }
  float value = total > 0.0 ? 0.5 + 0.5 * sum / total : 0.5;
  return clamp(channel.inverted > 0.5 ? 1.0 - value : value, 0.0, 1.0);
}

// Connected like gradient noise, billowy like cells (A. Schneider, "The Real-Time Volumetric
// Cloudscapes of Horizon: Zero Dawn", SIGGRAPH 2015): `billows` lifts the low values of `connected`.
float perlin_worley(float connected, float billows) {
  return clamp(billows + connected * (1.0 - billows), 0.0, 1.0);
}

// Curl of a potential (here of the noise itself in the plane): a flow without sources, so what it
// carries is neither gathered nor spread (Bridson et al. 2007). Central differences over a texel.
vec2 tiled_curl(vec2 at, int cells, int texels, int seed) {
  float e = 1.0 / float(texels);
  float north = tiled_gradient_noise(vec3(at.x, at.y + e, 0.37), cells, seed);
  float south = tiled_gradient_noise(vec3(at.x, at.y - e, 0.37), cells, seed);
  float east = tiled_gradient_noise(vec3(at.x + e, at.y, 0.37), cells, seed);
  float west = tiled_gradient_noise(vec3(at.x - e, at.y, 0.37), cells, seed);
  return vec2(north - south, west - east) / (2.0 * e * float(cells));
}
