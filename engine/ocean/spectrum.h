#pragma once
#include <glm/vec2.hpp>

#include <complex>
#include <cstdint>
#include <vector>

#include "engine/ocean/sea_state.h"

namespace offing {

/// The slope covariance of a surface, in world axes: <sx sx>, <sz sz>, <sx sz>.
struct SlopeVariance {
  double xx = 0.0, zz = 0.0, xz = 0.0;
  double total() const { return xx + zz; }
  SlopeVariance& operator+=(const SlopeVariance& other);
};

/// What oceanographers say about a sea.
struct SeaStatistics {
  double m0 = 0.0;                 ///< variance of the height, m^2
  double hs = 0.0;                 ///< significant height 4 sqrt(m0), m
  double tp = 0.0;                 ///< period of the spectrum's peak, s; 0 without waves
  double mean_square_slope = 0.0;  ///< capillaries included
};

/// The continuous spectrum of wind sea plus swell.
class SeaSpectrum {
 public:
  /// `wind_speed` in m/s at 10 m, `wind_to` the unit vector (x, z) it blows toward.
  SeaSpectrum(const SeaState& state, double wind_speed, glm::dvec2 wind_to);

  /// One-sided frequency spectrum of all waves, m^2 s, at w > 0.
  double frequency_density(double w) const;
  /// Variance per area of the wave-vector plane, m^4: S(w) D(w, theta) (dw/dk) / k.
  double density(glm::dvec2 k) const;
  /// Angular frequency (rad/s) of a wave number: the dispersion at this depth.
  double frequency(double k) const;

  const SeaStatistics& statistics() const { return statistics_; }
  /// Length of the longest of the two peaks' waves, m; 0 on a flat sea.
  double longest_peak() const { return longest_peak_; }
  double wind_speed() const { return wind_speed_; }
  glm::dvec2 wind_to() const { return wind_to_; }

 private:
  double wind_sea(double w, double k) const;
  double wind_spreading(double w, double angle) const;
  double elongated_donelan_banner(double w, double angle) const;
  SeaStatistics integrate() const;

  SeaState state_;
  double wind_speed_;
  glm::dvec2 wind_to_, swell_to_;
  double wind_peak_ = 0.0;   ///< rad/s; 0 without a wind sea
  double swell_peak_ = 0.0;  ///< rad/s; 0 without a swell
  double alpha_ = 0.0;
  double longest_peak_ = 0.0;
  std::vector<double> elongated_norms_;  ///< by frequency, for Donelan-Banner drawn out
  SeaStatistics statistics_;
};

/// One periodic patch of sea and the waves it carries: those with k_min <= |k| < k_max.
struct CascadeBand {
  double length = 0.0;  ///< period in both directions, m
  double angle = 0.0;   ///< of its grid against the world's axes, rad
  double k_min = 0.0, k_max = 0.0;
};

/// Waves longer than those with this many periods per patch lie in all grids from 128 points on.
inline constexpr double kSharedPeriods = 31.5;

/// Bands that meet without overlap or gap; every wave gets at least four grid points. Lengths and
/// the edges between bands depend on the sea alone wherever `size` is 128 or more, so that a finer
/// grid or one more cascade has the same waves and adds finer ones to them: what floats feels the
/// same sea at every quality.
std::vector<CascadeBand> choose_bands(const SeaSpectrum& spectrum, int count, int size);

/// Levels of the maps that have an entry in Cascade::resolved.
inline constexpr int kVarianceLevels = 10;

/// The random waves of one band on a grid of size × size wave vectors.
struct Cascade {
  CascadeBand band;
  int size = 0;
  /// At [iz * size + ix], for wave numbers (2 pi / length) (n(ix), n(iz)) in the cascade's own
  /// axes; n(i) = i < size/2 ? i : i - size. A wave moves toward its wave vector: h(x, t) = 2 Re
  /// sum h0 exp(i (k.x - w t)).
  std::vector<std::complex<double>> h0;
  std::vector<double> frequency;  ///< rad/s
  double variance = 0.0;          ///< expected, m^2
  /// Expected slope covariance that a map level still shows (level 0: all of the band).
  SlopeVariance resolved[kVarianceLevels];
  /// The same by wave indices, at [|nz| * size / 4 + |nx|].
  std::vector<SlopeVariance> slope_cells;
  double slope_rate = 0.0;  ///< expected variance of the slopes' rate of change, 1/s^2

  /// Wave vector of a grid place in world axes, rad/m.
  glm::dvec2 wave_vector(int ix, int iz) const;
};

/// h0 = (xr + i xi) sqrt(E) / 2 with normals that depend on the seed, the cascade's number and the
/// signed wave indices only, all scaled so that 2 sum |h0|^2 is the band's energy in every draw.
/// The Nyquist row and column and k = 0 are empty.
Cascade make_cascade(const SeaSpectrum& spectrum, const CascadeBand& band, int size,
                     std::uint64_t seed, int number);

/// Total slope covariance of the sea with its finest ripples, after Cox & Munk 1954 (their clean
/// sea): .00316 U along the wind, .003 + .00192 U across it. U in m/s (theirs at 12.5 m; 1.018
/// U10).
SlopeVariance cox_munk(double wind_speed, glm::dvec2 wind_to);

}  // namespace offing
