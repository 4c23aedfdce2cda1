// Light within clouds. Compiled as GLSL and as double-precision C++; needs lib/phase.glsl before it.
// Everything is per lux of the light before it meets the cloud; sources are per unit of optical depth, so
// that radiance = ∫ source e^-τ dτ.

// Two Henyey-Greenstein lobes: `share` of the light goes into the backward one.
float dual_phase(float forward, float backward, float share, float cosine) {
  return mix(henyey_greenstein(forward, cosine), henyey_greenstein(-backward, cosine), share);
}

// ∫ clamp(f / width, 0, 1) df from 0.
float cloud_ramp_integral(float f, float width) {
  float inside = clamp(f, 0.0, width);
  return 0.5 * inside * inside / width + max(f - width, 0.0);
}

// Mean of clamp(f / width, 0, 1) while f goes evenly from a to b: what a step holds whose ends lie on
// both sides of an edge. Exact for any length of the step where the field is linear.
float cloud_mean_ramp(float a, float b, float width) {
  float across = b - a;
  if (abs(across) < 1.0e-4) return clamp(0.5 * (a + b) / width, 0.0, 1.0);
  return clamp((cloud_ramp_integral(b, width) - cloud_ramp_integral(a, width)) / across, 0.0, 1.0);
}

// One step of the march with a source that does not change along it (Hillaire 2016): its light at the
// near end, per unit of source. Exact for any optical depth, and 0/0 nowhere.
float cloud_step_light(float depth) { return depth < 1.0e-4 ? depth : 1.0 - exp(-depth); }

// Light that was scattered often: radiance as i0 + i1 cosine, with the cosine to the way the light flows.
struct CloudDiffuse {
  float mean;  // i0
  float flow;  // i1
};

// Eddington's approximation for a slab that absorbs nothing, `t` deep from the lit side and `whole`
// thick, both similarity-scaled by 1 - g (Joseph, Wiscombe & Weinman 1976), for light at this cosine of
// the slab's normal. There the albedo is 1 - ((2/3 + µ) + (2/3 - µ) e^(-whole/µ)) / (4/3 + whole), and
// what is not reflected flows through, whatever the depth.
float cloud_albedo(float whole, float mu) {
  return 1.0 - ((2.0 / 3.0 + mu) + (2.0 / 3.0 - mu) * exp(-whole / mu)) / (4.0 / 3.0 + whole);
}
CloudDiffuse cloud_diffuse(float t, float whole, float mu) {
  float albedo = cloud_albedo(whole, mu);
  float direct = exp(-t / mu);
  CloudDiffuse light;
  light.mean = max(mu * albedo / (2.0 * kPhasePi) - 3.0 * mu / (4.0 * kPhasePi) *
                   ((1.0 - albedo) * t - mu * (1.0 - direct)), 0.0);
  light.flow = 3.0 * mu / (4.0 * kPhasePi) * ((1.0 - albedo) - direct);
  return light;
}

// Octaves of the light that came straight or was only bent forward (after Wrenninge, Kulla & Lundqvist
// 2013, but each octave holds only what the one before has lost, so that none is counted twice). The
// light that has been scattered n times in a Henyey-Greenstein phase of g has g^n: octaves of 1, 2 and
// 4 scatterings, attenuated by e^-τ, e^-τ/2 and e^-(1-g)τ.
struct CloudOctaves {
  float once;
  float twice;
  float often;
};
float cloud_beam(CloudOctaves phases, float depth, float scaled) {
  float straight = exp(-depth);
  float bent = exp(-max(0.5 * depth, scaled));
  float spread = exp(-scaled);
  return phases.once * straight + phases.twice * (bent - straight) + phases.often * (spread - bent);
}
