// Phase functions: the share of scattered light that leaves per steradian at an angle from the way it
// came, given by its cosine (1 straight on). Each integrates to 1 over the sphere.
const float kPhasePi = 3.14159265358979323846;

// Molecules (Rayleigh 1871).
float rayleigh_phase(float cosine) {
  return 3.0 / (16.0 * kPhasePi) * (1.0 + cosine * cosine);
}

// Henyey & Greenstein 1941; the mean cosine is g.
float henyey_greenstein(float g, float cosine) {
  float d = max(1.0 + g * g - 2.0 * g * cosine, 1.0e-6);
  return (1.0 - g * g) / (4.0 * kPhasePi * d * sqrt(d));
}

// Henyey-Greenstein with the polarisation factor that makes it Rayleigh's at g = 0
// (Cornette & Shanks 1992).
float cornette_shanks(float g, float cosine) {
  return henyey_greenstein(g, cosine) * 1.5 * (1.0 + cosine * cosine) / (2.0 + g * g);
}
