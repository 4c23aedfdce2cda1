// The sea's formulas: dispersion, frequency spectra, directional spreading. Compiled as GLSL and as
// double-precision C++. Units: metres, seconds, radians; frequencies are angular (rad/s).
// S(w) is one-sided, in m^2 s; a spreading D(w, theta) integrates to 1 over the full circle.

const float kWaveGravity = 9.81;           // m/s^2
const float kWaveTension = 7.4e-5;         // surface tension over density, m^3/s^2
const float kWavePi = 3.14159265358979323846;
const float kDeep = 20.0;                  // beyond this k*depth, tanh(k*depth) is 1 in double

// ---- Dispersion: w^2 = (g k + sigma k^3) tanh(k h), Lamb, Hydrodynamics, art. 267 ---------------

float wave_depth_tanh(float k, float depth) {
  return k * depth > kDeep ? 1.0 : tanh(k * depth);
}

// Angular frequency of wave number k (rad/m) in water of this depth (m).
float wave_frequency(float k, float depth) {
  return sqrt((kWaveGravity * k + kWaveTension * k * k * k) * wave_depth_tanh(k, depth));
}

// Group speed dw/dk (m/s); k > 0.
float wave_group_speed(float k, float depth) {
  float t = wave_depth_tanh(k, depth);
  float inner = kWaveGravity * k + kWaveTension * k * k * k;
  float slope = (kWaveGravity + 3.0 * kWaveTension * k * k) * t + inner * depth * (1.0 - t * t);
  return slope / (2.0 * sqrt(inner * t));
}

// How far the water at the surface moves sideways over how far it moves up: coth kh (Airy), taken
// from the dispersion as (g k + sigma k^3) / w^2. Held at 4 (kh = .26): in thinner water the linear
// theory has no meaning for waves of any height.
const float kMostSideways = 4.0;
float wave_sideways(float k, float w) {
  return min((kWaveGravity * k + kWaveTension * k * k * k) / max(w * w, 1.0e-12), kMostSideways);
}

// The inverse of wave_frequency(): Newton steps from the deep-water gravity wave, which lies on the
// side of the root from which they converge.
float wave_number(float w, float depth) {
  float deep = w * w / kWaveGravity;
  float k = max(deep, w / sqrt(kWaveGravity * depth));
  for (int i = 0; i < 12; ++i) {
    float step = (wave_frequency(k, depth) - w) / wave_group_speed(k, depth);
    k = max(k - step, 0.1 * k);
  }
  return k;
}

// ---- Frequency spectra ---------------------------------------------------------------------------

// Pierson & Moskowitz 1964: alpha g^2 w^-5 exp(-beta (g / (U19.5 w))^4), fully developed.
// U19.5 = 1.026 U10 (a logarithmic profile); wind in m/s at 10 m.
const float kPmAlpha = 0.0081;
const float kPmBeta = 0.74;
float pierson_moskowitz(float w, float wind) {
  float ratio = kWaveGravity / (1.026 * wind * w);
  float decay = kPmBeta * ratio * ratio * ratio * ratio;
  if (decay > 500.0) return 0.0;
  return kPmAlpha * kWaveGravity * kWaveGravity / (w * w * w * w * w) * exp(-decay);
}

// Where it peaks: dS/dw = 0 gives w^4 = 4/5 beta (g/U19.5)^4.
float pierson_moskowitz_peak(float wind) {
  return pow(0.8 * kPmBeta, 0.25) * kWaveGravity / (1.026 * wind);
}

// The JONSWAP shape (Hasselmann et al. 1973) with its peak at `peak`, `alpha` its level and `gamma`
// the peak enhancement.
float jonswap_shape(float w, float peak, float alpha, float gamma) {
  float ratio = peak / w;
  if (ratio > 5.0) return 0.0;  // exp(-1.25 * 625) = 0
  float width = w <= peak ? 0.07 : 0.09;
  float offset = (w - peak) / (width * peak);
  float enhancement = pow(gamma, exp(-0.5 * offset * offset));
  return alpha * kWaveGravity * kWaveGravity / (w * w * w * w * w) *
         exp(-1.25 * ratio * ratio * ratio * ratio) * enhancement;
}

// Fetch without dimension, chi = g F / U^2. Growth stops where the peak has come down to that of the
// fully developed sea, f U / g = .13 (Komen, Hasselmann & Hasselmann 1984 on Pierson & Moskowitz's
// data): 22 chi^(-1/3) = 2 pi .13 gives 2.0e4 in round figures. JONSWAP's energy, a fit of its own,
// passes that of Pierson & Moskowitz's spectrum sooner, at about 1.1e4, and stands 1.42 times above
// its height here. Fetch in metres, wind in m/s.
const float kFullyDevelopedFetch = 2.0e4;
float dimensionless_fetch(float wind, float fetch) {
  return min(kWaveGravity * fetch / (wind * wind), kFullyDevelopedFetch);
}
const float kJonswapGamma = 3.3;
float jonswap_alpha(float chi) { return 0.076 * pow(chi, -0.22); }
float jonswap_peak(float wind, float chi) {
  return 22.0 * kWaveGravity / wind * pow(chi, -1.0 / 3.0);
}
float jonswap(float w, float wind, float fetch) {
  float chi = dimensionless_fetch(wind, fetch);
  return jonswap_shape(w, jonswap_peak(wind, chi), jonswap_alpha(chi), kJonswapGamma);
}

// Kitaigorodskii et al. 1975, for TMA (Bouws et al. 1985): what finite depth leaves of a deep-water
// spectrum, by k h of the wave at that frequency: tanh^2 kh / (1 + 2kh / sinh 2kh).
float kitaigorodskii(float kh) {
  if (kh > kDeep) return 1.0;
  if (kh < 1.0e-6) return 0.5 * kh * kh;
  float t = tanh(kh);
  return t * t / (1.0 + 2.0 * kh / sinh(2.0 * kh));
}

// A swell of significant height `height` (m) and peak frequency `peak`: the JONSWAP shape, narrow
// (gamma 7, as fitted to swell by Goda 1983), scaled to m0 = height^2 / 16.
// kSwellIntegral = integral of x^-5 exp(-1.25 x^-4) 7^(…) dx.
const float kSwellGamma = 7.0;
const float kSwellIntegral = 0.4450338471;
float swell_spectrum(float w, float height, float peak) {
  float g2 = kWaveGravity * kWaveGravity;
  float alpha = height * height / 16.0 * peak * peak * peak * peak / (g2 * kSwellIntegral);
  return jonswap_shape(w, peak, alpha, kSwellGamma);
}

// ---- Directional spreading ----------------------------------------------------------------------

// Gamma(s + 1) / Gamma(s + 1/2), to 1e-11: the asymptotic series in 1/s after shifting s up by 8
// with Gamma(x + 1) = x Gamma(x).
float gamma_half_ratio(float s) {
  float factor = 1.0;
  float x = s;
  for (int i = 0; i < 8; ++i) {
    factor *= (x + 0.5) / (x + 1.0);
    x += 1.0;
  }
  float y = 1.0 / x;
  float series = 1.0 + y * (1.0 / 8.0 + y * (1.0 / 128.0 + y * (-5.0 / 1024.0 +
                 y * (-21.0 / 32768.0 + y * (399.0 / 262144.0 + y * (869.0 / 4194304.0))))));
  return factor * sqrt(x) * series;
}

// Longuet-Higgins, Cartwright & Smith 1963: Q(s) cos^2s(theta / 2).
float spread_cos2s(float theta, float s) {
  float c = abs(cos(0.5 * theta));
  return gamma_half_ratio(s) / (2.0 * sqrt(kWavePi)) * pow(max(c, 1.0e-30), 2.0 * s);
}

// The exponent after Mitsuyasu et al. 1975; `age` is g / (peak wind), the inverse of U/c.
float mitsuyasu_exponent(float w, float peak, float wind) {
  float at_peak = 11.5 * pow(peak * wind / kWaveGravity, -2.5);
  float ratio = w / peak;
  return at_peak * (ratio <= 1.0 ? pow(ratio, 5.0) : pow(ratio, -2.5));
}

// The exponent after Hasselmann, Dunckel & Ewing 1980.
float hasselmann_exponent(float w, float peak, float wind) {
  float ratio = w / peak;
  if (ratio <= 1.0) return 6.97 * pow(ratio, 4.06);
  return 9.77 * pow(ratio, -2.33 - 1.45 * (wind * peak / kWaveGravity - 1.17));
}

// What Horvath 2015 ("Empirical directional wave spectra for computer graphics") adds to the exponent
// so that crests grow long like those of a swell: 16 tanh(peak / w) xi^2, strongest below the peak.
float swell_elongation_exponent(float w, float peak, float xi) {
  return 16.0 * tanh(min(peak / w, 20.0)) * xi * xi;
}

// Donelan, Hamilton & Hui 1985 with Banner's 1990 tail: beta / (2 tanh(beta pi)) sech^2(beta theta).
float donelan_banner_beta(float w, float peak) {
  float ratio = w / peak;
  if (ratio < 0.56) return 2.61 * pow(0.56, 1.3);
  if (ratio < 0.95) return 2.61 * pow(ratio, 1.3);
  if (ratio < 1.6) return 2.28 * pow(ratio, -1.3);
  return pow(10.0, -0.4 + 0.8393 * exp(-0.567 * log(ratio * ratio)));
}
float spread_donelan_banner(float theta, float beta) {
  float c = cosh(beta * theta);
  return beta / (2.0 * tanh(beta * kWavePi) * c * c);
}
