#pragma once
#include <complex>
#include <span>
#include <vector>

#include "engine/ocean/spectrum.h"
#include "engine/ocean/water_surface.h"

namespace offing {

/// The displaced surface at a fixed parameter q (the place of the water at rest).
struct DirectPoint {
  glm::dvec3 displacement{0.0};            ///< Dx, h, Dz; m
  glm::dvec3 velocity{0.0};                ///< its rate of change; m/s
  glm::dvec2 slope{0.0};                   ///< dh/dx, dh/dz at fixed time
  double dxx = 0.0, dzz = 0.0, dxz = 0.0;  ///< derivatives of the horizontal displacement
};

/// The sea as the plain double-precision sum over all its waves: slow (about 0.1 ms a point) and
/// exact; what everything faster is measured against.
class DirectWater final : public WaterSurface {
 public:
  DirectWater(std::span<const Cascade> cascades, double choppiness);

  /// The surface at parameter points, without inverting.
  std::vector<DirectPoint> at_parameter(std::span<const glm::dvec2> points, double time) const;

  /// Inverts x = q + D(q) by Newton's method to 1 micrometre.
  void sample(std::span<const glm::dvec2> points, double time,
              std::span<WaterSample> out) const override;

 private:
  struct Wave {
    int nx, nz;               // signed wave numbers in the cascade's own axes
    std::complex<double> h0;  // twice, for the sum over half the plane
    double frequency;
    glm::dvec2 k;
    glm::dvec2 u;  // of D = i u H: c coth(kh) k / |k|
  };
  struct Waves {
    double dk, cosine, sine;
    int reach;  // largest |n|
    std::vector<Wave> waves;
  };
  /// Amplitudes 2 h0 exp(-i w t), in the order of the waves.
  std::vector<std::vector<std::complex<double>>> amplitudes(double time) const;
  DirectPoint sum(glm::dvec2 q,
                  const std::vector<std::vector<std::complex<double>>>& amplitudes) const;

  std::vector<Waves> cascades_;
};

}  // namespace offing
