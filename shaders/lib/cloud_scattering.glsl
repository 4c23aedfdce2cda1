// How much light a cloud scatters toward the eye. Needs lib/phase.glsl before it.
//
// All here is the source function J per illuminance E of the light (1/sr) or per radiance: along a ray
// the cloud adds integral of J sigma T ds. Droplets do not absorb visible light, so all is conservative.
//
// ---- Many scatterings ------------------------------------------------------------------------------
//
// "Octaves" of Wrenninge (below) know only how much cloud lies toward the light; but how bright a lit
// face is depends as much on what lies behind it (a slab of tau 4 returns a fifth of the light, one of
// tau 40 three quarters). A Beer shadow map knows both: the optical depth from a point to the light,
// and that of the whole ray. With the two, a slab can be solved in closed form:
//
//   J = E p(theta) e^-a                                scattered once
//     + E w p'(theta) (e^-a' - e^-a)                   scattered forward a few times, then toward us
//     + B (I0 + k g I1 mu)                             all the rest: the field of a slab
//
// a is the optical depth to the light, a' = (1 - g^2) a the same with what goes on nearly straight
// counted as not scattered (delta-Eddington: Joseph, Wiscombe & Weinman 1976), I0 + I1 mu Eddington's
// field in that slab, mu the cosine with the way in. p' is blurred by the turns before, as g^3.
// Marshak's boundary for the field (2/3), and for what the beam feeds it a length between that and
// Milne's (.7104). The remaining constants (B, k, w) were chosen by comparing with adding-doubling over
// g 0 to .9, optical depths .2 to 150 and sun heights of 6 to 90 degrees: albedo within .06 everywhere
// and within .045 for tau above 4 and a sun over 14 degrees; transmittance alike.
// tests/formula/cloud_scattering_test.cpp repeats it with other values.
const float kMarshak = 0.66666667;
const float kBeamBoundary = 0.68;
const float kFieldGain = 1.07;   // B
const float kFieldTilt = 0.73;   // k
const float kForwardGain = 1.28;
const float kForwardRise = 0.18;  // w: light that comes in flat soon finds the way out again
const float kForwardBlur = 3.0;
const float kLeastLeak = 5.0e-4;  // as good as none, and no division by 0

struct CloudField {
  float once;     // share of the beam that has not been scattered
  float forward;  // light that goes on nearly as the beam did, over E
  float mean;     // I0 over E, 1/sr
  float tilt;     // I1 over E, 1/sr; positive: more goes the beam's way than back
};

// The light in a cloud at a place with optical depth `above` along the ray to the light, of `total` on
// the whole ray (before and behind). `cosine` is that of the light with the normal of the slab that the
// cloud resembles: the sine of the sun's elevation for a layer, 1 for a heap. `g` is the droplets' mean
// cosine (-.9 to .9). `leak`, k below, is 0 for a slab without end to its sides.
//
// In optical depths t of the scaled slab Eddington's equations are
//   dI1/dt = -(k^2 / turned) I0 + (q/c) e^(-t/c)      dI0/dt = -turned I1 + q g' e^(-t/c)
// with k = 0 in a slab. A cloud that is only so wide loses light through its sides: of its modes across
// the lowest lives longest, a cosine, and takes k^2 I0 out of the balance. Then
//   I0 = A e^(-kt) + B e^(-k(t_end - t)) + P e^(-t/c)      P = -q c / (1 - k^2 c^2).
CloudField cloud_field(float above, float total, float cosine, float g, float leak) {
  float c = max(cosine, 0.02);
  float a = max(above, 0.0);
  float whole = max(total, a);
  float straight = 1.0 - g * g;
  float turned = 1.0 / (1.0 + g);  // 1 - g', of the scaled phase function
  float beam = exp(-straight * a);
  float beam_below = exp(-straight * whole);
  float q = 3.0 * c / (4.0 * kPhasePi);
  float k = clamp(leak, kLeastLeak, 0.85);
  float p = -q * c / (1.0 - k * k * c * c);
  // Nothing comes in from outside but the beam, above and below.
  float from_top = exp(-k * straight * a * c);
  float from_end = exp(-k * straight * (whole - a) * c);
  float across = from_top * from_end;
  float h = kMarshak * k / turned;
  float fed = q * kBeamBoundary - (kMarshak / turned) * (q + p / c);
  float at_top = fed - p, at_end = -beam_below * (fed + p);
  float into = 1.0 + h, back = across * (1.0 - h);
  float scale = 1.0 / (into * into - back * back);
  float top = scale * (into * at_top - back * at_end);
  float end = scale * (into * at_end - back * at_top);
  CloudField f;
  f.once = exp(-a);
  f.forward = kForwardGain * (1.0 - exp(-c / kForwardRise)) * max(beam - f.once, 0.0);
  f.mean = max(top * from_top + end * from_end + p * beam, 0.0);
  float slope = k * (end * from_end - top * from_top) - p / c * beam;  // dI0/dt
  f.tilt = (q * beam - slope) / turned - q * beam;
  return f;
}

// J / E. `phase` is p at the angle between light and eye, `angle_cosine` its cosine (1: looking into
// the light), `mu` the cosine between the eye's ray and the slab's normal that points to the light's
// side (looking from below at a layer: positive).
float cloud_source(CloudField f, float phase, float angle_cosine, float mu, float g) {
  float blurred = henyey_greenstein(sign(g) * pow(abs(g), kForwardBlur), angle_cosine);
  return phase * f.once + blurred * f.forward +
         kFieldGain * max(f.mean + kFieldTilt * g * f.tilt * mu, 0.0);
}

// J of light that comes from all sides: radiance `top` on the slab's upper face and `bottom` on its
// lower one (sky and sea), at optical depth `above` of `total` along the normal. Never outside the two;
// where they are alike it is that, so a cloud in an even light of 1 is 1 (the furnace).
vec3 cloud_ambient(float above, float total, vec3 top, vec3 bottom, float mu, float g) {
  float straight = 1.0 - g;  // (1 - g^2) / (1 + g)
  float whole = max(total, above);
  float per_depth = 1.0 / (2.0 * kMarshak + straight * whole);
  float share = (kMarshak + straight * above - kFieldTilt * g * mu) * per_depth;
  return mix(top, bottom, clamp(share, 0.0, 1.0));
}

// Lightning's air glows in the blue of nitrogen's lines.
const vec3 kFlashColour = vec3(0.85, 0.95, 1.35);

// J per candela of a point of light inside a cloud, at a `distance` (m) from it. A cloud takes none of its
// light and is much deeper than it is seen into: what arrives at its surface, 1 / distance^2 by the
// cosine, leaves there in all directions; over all of a plane that is half of what the point gives.
float cloud_glow(float distance) {
  const float kDepth = 1200.0;  // m, of the point beneath the surface of a storm some kilometres wide
  float r2 = distance * distance + kDepth * kDepth;
  return kDepth / (kPhasePi * r2 * sqrt(r2));
}

// ---- Octaves ----------------------------------------------------------------------------------------
// Wrenninge, Kulla & Lundqvist, "Oz: The Great and Volumetric", SIGGRAPH 2013 Talks, as Mijolovic 2020,
// eq. 5.3 and 5.4: octave i has its optical depth times a^i, its amount times b^i, its g times c^i.
float cloud_octaves(float above, float angle_cosine, float g, int octaves, float a, float b, float c) {
  float sum = 0.0;
  float depth = above;
  float amount = 1.0;
  float eccentricity = g;
  for (int i = 0; i < octaves; ++i) {
    sum += amount * henyey_greenstein(eccentricity, angle_cosine) * exp(-depth);
    depth *= a;
    amount *= b;
    eccentricity *= c;
  }
  return sum;
}

// What a thin cloud lacks because light has not yet been turned often (Schneider 2015; Raja Huertas
// 2023, eq. 3.3). Multiplied onto Beer's law; takes light away.
float cloud_powder(float depth) { return 1.0 - exp(-2.0 * depth); }

// ---- One step ---------------------------------------------------------------------------------------
// Integral of e^(-sigma s) from 0 to d: times J sigma, what an even step adds. (S - S e^(-sigma d))/sigma
// of Hillaire 2015, also where sigma is 0.
float cloud_step(float sigma, float d) {
  float depth = sigma * d;
  return depth > 1.0e-3 ? (1.0 - exp(-depth)) / sigma : d * (1.0 - 0.5 * depth + depth * depth / 6.0);
}
