#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#define OFFING_GLSL "shaders/lib/waves.glsl"
#include "engine/core/glsl_double.h"

namespace offing::glsl {
namespace {

double integral(const std::function<double(double)>& f, double a, double b, int steps = 20000) {
  double sum = f(a) + f(b);
  for (int i = 1; i < steps; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * f(a + (b - a) * i / steps);
  return sum * (b - a) / steps / 3.0;
}
double m0(const std::function<double(double)>& s, double peak) {
  // In log w, up to where the w^-5 tail is closed by its own integral.
  const double last = 40.0 * peak;
  return integral([&](double u) { return std::exp(u) * s(std::exp(u)); }, std::log(peak / 5.0),
                  std::log(last)) +
         0.25 * last * s(last);
}

TEST(Waves, DispersionAgreesWithIndependentValues) {
  EXPECT_NEAR(wave_frequency(0.1, 20.0), 0.972477, 1e-6);
  EXPECT_NEAR(wave_group_speed(0.1, 20.0), 5.575084, 5e-6);
  EXPECT_NEAR(wave_frequency(1.0, 5.0), 3.131950, 1.5e-5);  // capillarity adds 1.2e-5
  EXPECT_NEAR(wave_group_speed(1.0, 5.0), 1.567397, 4e-5);  // … and 2.9e-5 here
  EXPECT_NEAR(wave_frequency(100.0, 5.0), 32.480764, 1e-5);
  EXPECT_NEAR(wave_group_speed(100.0, 5.0), 0.185187, 1e-6);
}

TEST(Waves, SlowestWaveIsWhereCapillarityMeetsGravity) {
  double slowest = 1e9, at = 0.0;
  for (double k = 100.0; k < 1000.0; k += 0.05) {
    const double speed = wave_frequency(k, 100.0) / k;
    if (speed < slowest) slowest = speed, at = 2.0 * kWavePi / k;
  }
  EXPECT_NEAR(slowest, 0.23213, 1e-5);
  EXPECT_NEAR(at, 0.01726, 1e-5);
}

TEST(Waves, GroupSpeedIsTheDerivativeAndWaveNumberTheInverse) {
  for (const double depth : {0.5, 5.0, 50.0, 1e4}) {
    for (double k = 1e-4; k < 3000.0; k *= 1.7) {
      const double d = 1e-5 * k;
      const double slope =
          (wave_frequency(k + d, depth) - wave_frequency(k - d, depth)) / (2.0 * d);
      EXPECT_NEAR(wave_group_speed(k, depth) / slope, 1.0, 1e-8) << k << " " << depth;
      EXPECT_NEAR(wave_number(wave_frequency(k, depth), depth) / k, 1.0, 1e-10);
    }
  }
}

TEST(Waves, PiersonMoskowitzHasItsClosedForms) {
  for (const double wind : {5.0, 10.0, 15.0, 20.0}) {
    const double u = 1.026 * wind;
    // m0 = alpha U^4 / (4 beta g^2)
    const double closed = 0.0081 * std::pow(u, 4) / (4.0 * 0.74 * 9.81 * 9.81);
    const double peak = pierson_moskowitz_peak(wind);
    const double sum = m0([&](double w) { return pierson_moskowitz(w, wind); }, peak);
    EXPECT_NEAR(sum / closed, 1.0, 1e-6);
    const double s = pierson_moskowitz(peak, wind);
    EXPECT_LT(pierson_moskowitz(0.999 * peak, wind), s);
    EXPECT_LT(pierson_moskowitz(1.001 * peak, wind), s);
  }
  EXPECT_NEAR(2.0 * kWavePi / pierson_moskowitz_peak(10.0), 7.492, 1e-3);
}

TEST(Waves, JonswapAgreesWithIndependentValues) {
  const struct {
    double wind, fetch, peak, hs;
  } rows[] = {{5, 50e3, 1.6004, 0.7864},
              {10, 100e3, 1.0082, 2.1386},
              {15, 100e3, 0.8807, 3.0638},
              {20, 500e3, 0.4680, 9.6857}};
  for (const auto& row : rows) {
    // These rows lie on both sides of full development; their growth is not limited.
    const double chi = 9.81 * row.fetch / (row.wind * row.wind);
    const double peak = jonswap_peak(row.wind, chi);
    EXPECT_NEAR(peak, row.peak, 1e-4);
    const double variance =
        m0([&](double w) { return jonswap_shape(w, peak, jonswap_alpha(chi), 3.3); }, peak);
    EXPECT_NEAR(4.0 * std::sqrt(variance), row.hs, 2e-4);
  }
  EXPECT_EQ(dimensionless_fetch(5.0, 2000e3), kFullyDevelopedFetch);
}

TEST(Waves, SwellHasTheHeightItWasGiven) {
  for (const double period : {5.0, 12.0, 20.0}) {
    const double peak = 2.0 * kWavePi / period;
    const double variance = m0([&](double w) { return swell_spectrum(w, 2.5, peak); }, peak);
    EXPECT_NEAR(4.0 * std::sqrt(variance), 2.5, 1e-4);
  }
}

TEST(Waves, DepthFunctionAgreesWithIndependentValues) {
  const struct {
    double w, phi;
  } rows[] = {{0.5, 0.12480}, {1.0, 0.48277}, {1.5, 0.87853}, {2.0, 0.99336}};
  const double depth = 10.0;  // w_h = w sqrt(h / g)
  for (const auto& row : rows) {
    const double k = wave_number(row.w * std::sqrt(9.81 / depth), depth);
    EXPECT_NEAR(kitaigorodskii(k * depth), row.phi, 3e-5);
  }
  EXPECT_NEAR(kitaigorodskii(1e-4), 0.5e-8, 1e-14);
  EXPECT_EQ(kitaigorodskii(1e6), 1.0);
}

TEST(Waves, TmaAgreesWithIndependentHeights) {
  const double chi = 9.81 * 100e3 / 225.0, peak = jonswap_peak(15.0, chi);
  for (const auto& [depth, hs] : {std::pair{5.0, 1.6409}, std::pair{20.0, 2.7089}}) {
    const double variance = m0(
        [&, h = depth](double w) {
          return jonswap_shape(w, peak, jonswap_alpha(chi), 3.3) *
                 kitaigorodskii(wave_number(w, h) * h);
        },
        peak);
    EXPECT_NEAR(4.0 * std::sqrt(variance), hs, 3e-4);
  }
}

TEST(Waves, GammaRatioAgreesWithTheLibrary) {
  for (double s = 0.0; s < 200.0; s += 0.37) {
    const double expected = std::exp(std::lgamma(s + 1.0) - std::lgamma(s + 0.5));
    EXPECT_NEAR(gamma_half_ratio(s) / expected, 1.0, 1e-9) << s;
  }
}

TEST(Waves, EverySpreadingIntegratesToOne) {
  const auto total = [](auto f) { return integral(f, -kWavePi, kWavePi); };
  for (const double s : {0.05, 0.5, 1.0, 6.0, 30.0, 75.0}) {
    // |cos|^2s has a cusp at the back for small s, where Simpson's rule converges slowly.
    EXPECT_NEAR(total([&](double a) { return spread_cos2s(a, s); }), 1.0, 2e-4) << s;
  }
  for (double ratio = 0.4; ratio < 20.0; ratio *= 1.3) {
    const double beta = donelan_banner_beta(ratio, 1.0);
    EXPECT_NEAR(total([&](double a) { return spread_donelan_banner(a, beta); }), 1.0, 1e-9);
  }
}

TEST(Waves, SpreadingParametersAreContinuousAtTheirJoints) {
  EXPECT_NEAR(mitsuyasu_exponent(1.0 - 1e-9, 1.0, 10.0), mitsuyasu_exponent(1.0 + 1e-9, 1.0, 10.0),
              1e-6);
  EXPECT_NEAR(donelan_banner_beta(0.56 - 1e-9, 1.0), donelan_banner_beta(0.56 + 1e-9, 1.0), 1e-6);
  EXPECT_NEAR(donelan_banner_beta(1.6 - 1e-9, 1.0), donelan_banner_beta(1.6 + 1e-9, 1.0), 2e-3);
}

}  // namespace
}  // namespace offing::glsl
