#pragma once
#include <vector>

namespace offing::test {

/// Share of a beam's light that a slab over black ground sends back, for beams at each of
/// `cosines` (of the angle to the normal, > 0). Optical depth `depth`, Henyey-Greenstein scattering
/// with `g` (0 to 0.95), single-scattering albedo `albedo`. By adding and doubling in double
/// precision: 20 streams a hemisphere, from a layer of 1e-7 on; good to 3e-4. Source: H. van de
/// Hulst, "Multiple Light Scattering", 1980, chapter 4; the peak cut as W. Wiscombe, J. Atmos. Sci.
/// 34, 1977.
std::vector<double> slab_albedo(double depth, double g, const std::vector<double>& cosines,
                                double albedo = 1.0);

/// Points and weights of Gauss's quadrature on 0 … 1.
struct Quadrature {
  std::vector<double> points, weights;
};
Quadrature gauss_legendre(int count);

}  // namespace offing::test
