// The reflection probe's map: two squares, one for the directions above the level and one for those
// below it, so that nothing of the sky bleeds into the sea. Compiled as GLSL and as double C++.
//
// A square is an octahedron's half (Cigolle et al., "A Survey of Efficient Representations for
// Independent Unit Vectors", JCGT 2014) with its radius warped: rho = 0 at the pole, 1 at the level,
// and fine at the level with the square root of the sine, where a sky changes most. Values at the
// square's edges lie in the centres of its outermost texels: both squares agree along the level.

// Levels of roughness by the GGX width alpha: 0 is a mirror, 1 a lobe finer than what is seen; from 2 on alpha
// grows by the same factor up to 1 at the last.
const float kProbeSharpest = 0.0042;
const float kProbeKnee = 0.0076;
const float kProbeLast = 12.0;
float probe_alpha(float level) {
  return level < 2.0 ? kProbeSharpest * pow(kProbeKnee / kProbeSharpest, level - 1.0)
                     : pow(kProbeKnee, (kProbeLast - level) / (kProbeLast - 2.0));
}
float probe_level_rough(float alpha) {  // of lobes wider than the knee, which is level 2
  return 2.0 + (kProbeLast - 2.0) * (1.0 - log(max(alpha, kProbeKnee)) / log(kProbeKnee));
}
float probe_level(float alpha) {
  float blur = clamp(alpha / kProbeSharpest, 0.0, 1.0);
  float sharp = log(clamp(alpha, kProbeSharpest, kProbeKnee) / kProbeSharpest) / log(kProbeKnee / kProbeSharpest);
  return blur * sqrt(blur) + sharp + probe_level_rough(alpha) - 2.0;
}

// Place of a direction (unit) in its square, 0 to 1.
vec2 probe_units(vec3 direction) {
  float w = sqrt(max(1.0 - abs(direction.y), 0.0));
  float rho = 1.0 - sqrt(1.0 - min(w, 1.0));
  float share = rho / max(abs(direction.x) + abs(direction.z), 1.0e-12);
  float x = direction.x * share;
  float z = direction.z * share;
  return vec2(0.5 + 0.5 * (x + z), 0.5 + 0.5 * (z - x));
}

// The direction (unit) of a place; `side` 1 above the level, -1 below.
vec3 probe_direction(vec2 units, float side) {
  float p = 2.0 * units.x - 1.0;
  float q = 2.0 * units.y - 1.0;
  float x = 0.5 * (p - q);
  float z = 0.5 * (p + q);
  float rho = min(abs(x) + abs(z), 1.0);
  float w = rho * (2.0 - rho);
  float across = w * sqrt(2.0 - w * w) / max(sqrt(x * x + z * z), 1.0e-12);
  return vec3(x * across, side * (1.0 - w * w), z * across);
}

// Solid angle per area of the square (whose side is 1), from the derivative of the above.
float probe_solid_angle(vec2 units) {
  float p = 2.0 * units.x - 1.0;
  float q = 2.0 * units.y - 1.0;
  float x = 0.5 * (p - q);
  float z = 0.5 * (p + q);
  float rho = abs(x) + abs(z);
  // |heading|_1^2 in (x, z) is rho^2 / |(x, z)|^2; towards the pole any of its values will do.
  float taxi = rho * rho / max(x * x + z * z, 1.0e-24);
  return 2.0 * 4.0 * (2.0 - rho) * (1.0 - min(rho, 1.0)) * (rho < 1.0e-9 ? 1.5 : taxi);
}

// Irradiance from spherical harmonics, the nine of orders 0 to 2 (Ramamoorthi & Hanrahan 2001) and of
// order 4 the one about the vertical, without which a sky that is bright along its horizon lights a deck
// by a tenth too much: values of the basis at a direction, y being the polar axis.
struct ProbeBasis {
  float constant;
  vec3 linear;     // along x, y, z
  vec3 product;    // xy, yz, xz
  float zonal;     // 3 y^2 - 1
  float sectoral;  // x^2 - z^2
  float ring;      // 35 y^4 - 30 y^2 + 3
};
ProbeBasis probe_basis(vec3 d) {
  ProbeBasis b;
  b.constant = 0.28209479;
  b.linear = 0.48860251 * d;
  b.product = 1.09254843 * vec3(d.x * d.y, d.y * d.z, d.x * d.z);
  b.zonal = 0.31539157 * (3.0 * d.y * d.y - 1.0);
  b.sectoral = 0.54627422 * (d.x * d.x - d.z * d.z);
  float y2 = d.y * d.y;
  b.ring = 0.10578555 * ((35.0 * y2 - 30.0) * y2 + 3.0);
  return b;
}
// What the cosine of a lit surface makes of the orders 0, 1, 2 and 4.
const float kProbeCosine0 = 3.14159265;
const float kProbeCosine1 = 2.09439510;
const float kProbeCosine2 = 0.78539816;
const float kProbeCosine4 = -0.13089969;
