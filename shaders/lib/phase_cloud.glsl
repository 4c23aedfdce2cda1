// Phase functions of clouds. Needs lib/phase.glsl before it. As there: per steradian, by the cosine of
// the turn, each with an integral of 1 over the sphere.

// Two Henyey-Greenstein lobes: `share` of the light goes by the second, as a rule backward
// (Mijolovic 2020, eq. 5.2: g .9 and -.5, share .2).
float dual_henyey_greenstein(float g_first, float g_second, float share, float cosine) {
  return mix(henyey_greenstein(g_first, cosine), henyey_greenstein(g_second, cosine), share);
}

// A lobe with a bright edge round the light: `intensity` (0 to 1) of the light goes by a lobe of
// g = .99 - spread. Schneider ("The Real-time Volumetric Cloudscapes of Horizon Zero Dawn", SIGGRAPH
// 2015) takes the larger of the two, which makes light; a share does not.
float silver_lining(float g, float intensity, float spread, float cosine) {
  return mix(henyey_greenstein(g, cosine), henyey_greenstein(0.99 - spread, cosine), intensity);
}

// Draine 2003, "Scattering by interstellar dust grains", eq. 4: alpha 0 is Henyey-Greenstein,
// alpha 1 Cornette-Shanks.
float draine(float g, float alpha, float cosine) {
  return henyey_greenstein(g, cosine) * (1.0 + alpha * cosine * cosine) /
         (1.0 + alpha * (1.0 + 2.0 * g * g) / 3.0);
}

// Its mean cosine (ibid., eq. 5).
float draine_mean_cosine(float g, float alpha) {
  return g * (1.0 + alpha * (3.0 + 2.0 * g * g) / 5.0) / (1.0 + alpha * (1.0 + 2.0 * g * g) / 3.0);
}

// Water droplets of one mean diameter: a peak straight on and a broad lobe. Fitted to Mie's theory by
// Jendersie & d'Eon, "An Approximate Mie Scattering Function for Fog and Cloud Rendering", SIGGRAPH
// 2023 Talks, eq. 7-10, for diameters of 5 to 50 um.
struct DropletPhase {
  float g_peak;  // Henyey-Greenstein
  float g_lobe;  // Draine
  float alpha;
  float lobe;  // share of the light that goes by the broad lobe
};

DropletPhase droplet_phase(float diameter_um) {
  float d = clamp(diameter_um, 5.0, 50.0);
  DropletPhase p;
  p.g_peak = exp(-0.0990567 / (d - 1.67154));
  p.g_lobe = exp(-2.20679 / (d + 3.91029) - 0.428934);
  p.alpha = exp(3.62489 - 8.29288 / (d + 5.52825));
  p.lobe = exp(-0.599085 / (d - 0.641583) - 0.665888);
  return p;
}

float droplet_scattering(DropletPhase p, float cosine) {
  return mix(henyey_greenstein(p.g_peak, cosine), draine(p.g_lobe, p.alpha, cosine), p.lobe);
}

float droplet_mean_cosine(DropletPhase p) {
  return mix(p.g_peak, draine_mean_cosine(p.g_lobe, p.alpha), p.lobe);
}

// What that fit leaves out: the fog bow and the glory, as two more lobes. Where they stand is Airy's
// theory: the rainbow of rays at 137.9 degrees, moved inward and widened by (wavelength/diameter)^2/3,
// and rings as wide as wavelength/diameter round the point opposite to the light. Amounts and widths
// are read off Mie's series for droplets of 5 to 50 um with an effective variance of .1
// (tests/formula/phase_cloud_test.cpp compares them).
struct DropletBows {
  float bow_cosine;  // where the fog bow is brightest
  float bow_width;   // of its bell, in cosine
  float bow;         // share of the light
  float glory_width;  // in cosine from straight back
  float glory;        // share of the light
};

DropletBows droplet_bows(float diameter_um, float wavelength_um) {
  const float kRainbow = 2.4068;  // radians: 137.9 degrees
  const float kAiry = 0.733;      // radians: 42 degrees
  float ratio = wavelength_um / clamp(diameter_um, 5.0, 50.0);
  float shift = kAiry * pow(ratio, 0.6667);
  float angle = kRainbow + shift;
  DropletBows b;
  b.bow_cosine = cos(angle);
  b.bow_width = 0.9 * shift * sin(angle);
  b.bow = 0.0135;
  b.glory_width = 0.605 * ratio * ratio;
  b.glory = 7.2e-4 * pow(ratio / 0.055, 1.66);
  return b;
}

float droplet_scattering_with_bows(DropletPhase p, DropletBows b, float cosine) {
  float off = (cosine - b.bow_cosine) / b.bow_width;
  float bow = exp(-0.5 * off * off) / (2.506628 * 2.0 * kPhasePi * b.bow_width);
  float glory = exp(-(1.0 + cosine) / b.glory_width) / (2.0 * kPhasePi * b.glory_width);
  return (1.0 - b.bow - b.glory) * droplet_scattering(p, cosine) + b.bow * bow + b.glory * glory;
}
