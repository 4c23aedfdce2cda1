// Sparkle. Needs ocean/surface.glsl before it.
//
// The glitter's radiance is a mean over facets, but near by a pixel holds few that face the right way: their
// number scatters as chance has it (Poisson), with variance 1 / mean over the mean squared. A factor with
// that variance and the mean 1 stands for it, normal in its logarithm; it is the same for a patch of water
// of the pixel's size and changes as ripples do, some ten times a second.

const float kGlintsAcross = 2097152.0;  // cells of the finest size over the widest square of the foam map
const float kFinestGlint = 0.0015625;   // m: that square's width over kGlintsAcross
const float kGlintRate = 10.0;        // 1/s
// Mean number of mirroring facets per square metre and unit density of slopes: facets of some 2 cm^2,
// curved so that each mirrors a cone of .03 sr.
const float kGlintsPerArea = 20.0;

// The factor for `q` (m, water at rest, relative to the camera), a pixel of `size` m and the probability
// density of the mirroring slope.
float glint(vec2 q, float size, float density, float time) {
  float level = clamp(floor(log2(size / kFinestGlint) + 0.5), 0.0, 17.0);
  vec2 place = ocean.foam_map[kFoamLayers - 1].xy + q * ocean.foam_map[kFoamLayers - 1].z;
  uvec2 cell = uvec2(ivec2(floor(fract(place) * (kGlintsAcross * exp2(-level)))));
  uint own = (cell.x * 0x9e3779b1u) ^ (cell.y * 0x85ebca77u) ^ (uint(level) * 0xc2b2ae3du);
  own = (own ^ (own >> 15)) * 0x2c1b3c6du;
  uint moment = uint(time * kGlintRate + float(own >> 16) / 65536.0);
  uint h = (own ^ (moment * 0x297a2d39u));
  h = (h ^ (h >> 16)) * 0x85ebca6bu;
  h = (h ^ (h >> 13)) * 0xc2b2ae35u;
  h ^= h >> 16;
  // The sum of four even numbers is all but normal.
  float normal = (float((h & 255u) + ((h >> 8) & 255u) + ((h >> 16) & 255u) + (h >> 24)) / 255.0 - 2.0) *
                 1.7320508;
  float mean = max(kGlintsPerArea * density * size * size, 0.08);
  float variance = log(1.0 + 1.0 / mean);
  // (Its tails are short, which lowers the mean of the exponential: the logarithm of that mean, to v^3.)
  return exp(sqrt(variance) * normal - variance * (0.5 - variance * (0.0125 - 0.0006 * variance)));
}
