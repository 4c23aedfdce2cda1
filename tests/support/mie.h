#pragma once
#include <complex>
#include <vector>

namespace offing::test {

/// What a sphere does to light of one wavelength, of any polarisation.
struct MieSphere {
  double extinction = 0.0;    ///< efficiency: cross-section over the sphere's own
  double scattering = 0.0;    ///< the same of the light that is only turned
  double mean_cosine = 0.0;   ///< of the turn
  std::vector<double> phase;  ///< per steradian, at each of the cosines asked for
};

/// Mie's series for a sphere of size x = 2π radius / wavelength (0.01 to 2000) and refractive index
/// `index` (real part above 1, imaginary part at least 0) relative to what is round it. Source:
/// C. Bohren, D. Huffman, "Absorption and Scattering of Light by Small Particles", Wiley 1983,
/// eq. 4.57, 4.61, 4.62, 4.74 and appendix A (the logarithmic derivative by downward recurrence).
MieSphere mie_sphere(double x, std::complex<double> index, const std::vector<double>& cosines);

/// The refractive index of water at 20 °C: 400 to 700 nm, within 0.0005. Source: Cauchy's formula
/// through the values of D. Segelstein (1981). Its absorption is nothing to a droplet.
double water_index(double wavelength_nm);

/// The phase function of a cloud: droplets whose radius is spread by a gamma distribution,
/// n(r) ∝ r^((1 − 3 v)/v) exp(−r / (r_e v)), of effective diameter `diameter_um` (µm) and effective
/// variance v. `radii` quadrature points. Source: J. Hansen, L. Travis, "Light scattering in
/// planetary atmospheres", Space Science Reviews 16, 1974, eq. 2.56.
MieSphere mie_cloud(double diameter_um, double variance, double wavelength_nm,
                    const std::vector<double>& cosines, int radii = 64);

}  // namespace offing::test
