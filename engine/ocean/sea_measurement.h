#pragma once
#include <span>

#include "engine/ocean/spectrum.h"

namespace offing {

/// What the maps of one moment say of the sea, computed from them alone.
struct SeaMeasurement {
  double m0 = 0.0;  ///< sum of the height variances of the cascades, m^2
  double hs = 0.0;  ///< 4 sqrt(m0), m
  /// Peak period, s, from the moments of the fourth power of the measured spectrum (the Delft
  /// method: one sea of random waves has no clean peak); 0 without waves.
  double tp = 0.0;
};

/// `displacement` holds four values a point, the height second, by cascade, row and column, as
/// SeaMaps keeps it; the cascades say which frequency a wave number has.
SeaMeasurement measure_sea(std::span<const Cascade> cascades, std::span<const float> displacement);

}  // namespace offing
