#include "support/mie.h"

#include <algorithm>
#include <cmath>

namespace offing::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

using Complex = std::complex<double>;

/// D_n(z) = d ln(z j_n(z)) / dz, n = 0 … count: stable downward only.
std::vector<Complex> logarithmic_derivative(Complex z, int count) {
  const int start = std::max(count, static_cast<int>(std::abs(z))) + 15;
  std::vector<Complex> d(static_cast<std::size_t>(start) + 1);
  for (int n = start; n > 0; --n) {
    const Complex ratio = static_cast<double>(n) / z;
    d[static_cast<std::size_t>(n) - 1] = ratio - 1.0 / (d[static_cast<std::size_t>(n)] + ratio);
  }
  return d;
}

}  // namespace

MieSphere mie_sphere(double x, std::complex<double> index, const std::vector<double>& cosines) {
  // Wiscombe's length of the series.
  const int count = static_cast<int>(std::ceil(x + 4.05 * std::cbrt(x) + 2.0));
  const std::vector<Complex> derivative = logarithmic_derivative(index * x, count);

  // Riccati-Bessel functions: psi = x j, xi = x h.
  double psi_before = std::cos(x), psi = std::sin(x);
  double chi_before = -std::sin(x), chi = std::cos(x);
  std::vector<Complex> a(static_cast<std::size_t>(count) + 1), b(a);
  MieSphere sphere;
  for (int n = 1; n <= count; ++n) {
    const auto i = static_cast<std::size_t>(n);
    const double psi_now = (2.0 * n - 1.0) / x * psi - psi_before;
    const double chi_now = (2.0 * n - 1.0) / x * chi - chi_before;
    const Complex xi_now(psi_now, -chi_now), xi(psi, -chi);
    const Complex electric = derivative[i] / index + n / x,
                  magnetic = derivative[i] * index + n / x;
    a[i] = (electric * psi_now - psi) / (electric * xi_now - xi);
    b[i] = (magnetic * psi_now - psi) / (magnetic * xi_now - xi);
    psi_before = psi;
    psi = psi_now;
    chi_before = chi;
    chi = chi_now;
    sphere.extinction += (2.0 * n + 1.0) * (a[i] + b[i]).real();
    sphere.scattering += (2.0 * n + 1.0) * (std::norm(a[i]) + std::norm(b[i]));
    if (n > 1) {
      const double m = n - 1.0;
      sphere.mean_cosine +=
          m * (m + 2.0) / (m + 1.0) *
              (a[i - 1] * std::conj(a[i]) + b[i - 1] * std::conj(b[i])).real() +
          (2.0 * m + 1.0) / (m * (m + 1.0)) * (a[i - 1] * std::conj(b[i - 1])).real();
    }
  }
  const double scattered = sphere.scattering;  // the bare sum: normalises the phase function
  sphere.extinction *= 2.0 / (x * x);
  sphere.scattering *= 2.0 / (x * x);
  sphere.mean_cosine *= 2.0 / scattered;

  sphere.phase.reserve(cosines.size());
  for (const double cosine : cosines) {
    double pi_before = 0.0, pi = 1.0;  // angular functions pi_0, pi_1
    Complex s1(0.0), s2(0.0);
    for (int n = 1; n <= count; ++n) {
      const auto i = static_cast<std::size_t>(n);
      const double tau = n * cosine * pi - (n + 1.0) * pi_before;
      const double share = (2.0 * n + 1.0) / (n * (n + 1.0));
      s1 += share * (a[i] * pi + b[i] * tau);
      s2 += share * (a[i] * tau + b[i] * pi);
      const double pi_next = ((2.0 * n + 1.0) * cosine * pi - (n + 1.0) * pi_before) / n;
      pi_before = pi;
      pi = pi_next;
    }
    sphere.phase.push_back((std::norm(s1) + std::norm(s2)) / (4.0 * kPi * scattered));
  }
  return sphere;
}

double water_index(double wavelength_nm) {
  return 1.3240 + 3046.0 / (wavelength_nm * wavelength_nm);
}

MieSphere mie_cloud(double diameter_um, double variance, double wavelength_nm,
                    const std::vector<double>& cosines, int radii) {
  const double effective = 0.5 * diameter_um, index = water_index(wavelength_nm);
  const double lowest = 0.1 * effective, highest = effective * (1.0 + 6.0 * std::sqrt(variance));
  MieSphere cloud;
  cloud.phase.assign(cosines.size(), 0.0);
  double area = 0.0;
  for (int i = 0; i < radii; ++i) {
    const double r = lowest + (highest - lowest) * (i + 0.5) / radii;
    const double number = std::exp((1.0 - 3.0 * variance) / variance * std::log(r / effective) -
                                   (r / effective - 1.0) / variance);
    const MieSphere one = mie_sphere(2.0 * kPi * r * 1e3 / wavelength_nm, {index, 0.0}, cosines);
    const double share = number * r * r;
    area += share;
    cloud.extinction += share * one.extinction;
    cloud.scattering += share * one.scattering;
    cloud.mean_cosine += share * one.scattering * one.mean_cosine;
    for (std::size_t k = 0; k < cosines.size(); ++k)
      cloud.phase[k] += share * one.scattering * one.phase[k];
  }
  for (double& value : cloud.phase) value /= cloud.scattering;
  cloud.mean_cosine /= cloud.scattering;
  cloud.scattering /= area;
  cloud.extinction /= area;
  return cloud;
}

}  // namespace offing::test
