// Rain: how much falls where the weather map rains, and what it takes from the light. Compiled as GLSL and
// as double C++.

// Rate (mm/h) for the map's 0 … 1; a shower is far heavier in its core than round it.
float rain_rate(float rain, float heaviest) { return heaviest * rain * rain; }

// Extinction (1/m) of visible light in rain of this rate (mm/h). Drops are large: each takes twice its
// cross-section. Marshall & Palmer 1948: N(D) = N0 e^(-L D), N0 = 8000 /m^3/mm, L = 4.1 R^-.21 /mm; the
// integral of 2 (pi/4) D^2 N is pi N0 / L^3.
float rain_extinction(float rate) {
  float r = pow(max(rate, 0.0), 0.63);
  return 3.14159265 * 8000.0 * 1.0e-6 / (4.1 * 4.1 * 4.1) * r;
}
