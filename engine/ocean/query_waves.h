#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/ocean/spectrum.h"

namespace offing {

/// The waves that water queries know: the longest cascades of a sea on the coarsest grids that hold
/// them (four points per shortest wave). Their amplitudes are scaled so that a transform gives the
/// coefficients of cubic B-splines instead of heights: each wave by the gain with which splines
/// come closest to it (least squares: 1.2 % off at four points per wave, .2 % at six, where
/// Catmull-Rom's cubic is 9 % and 2 % off).
class QueryWaves {
 public:
  QueryWaves(std::span<const Cascade> cascades, int count);

  int size() const { return size_; }
  /// Trimmed to `size`, amplitudes scaled.
  std::span<const Cascade> cascades() const { return cascades_; }
  std::size_t points() const {
    return cascades_.size() * static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_);
  }

 private:
  int size_ = 0;
  std::vector<Cascade> cascades_;
};

/// Seconds between the moments at which the waves are transformed; between them a cubic of values
/// and rates holds: 2e-4 of a wave of 3 m, nothing of longer ones. A power of two, so that moments
/// are exact at any time.
inline constexpr double kMomentStep = 0.125;

/// The waves at the time index × kMomentStep: spline coefficients, eight floats a point by cascade,
/// row and column: Dx, h, Dz, 0 and their rates of change (m, m/s), for choppiness 1.
struct WaveMoment {
  std::int64_t index = 0;
  std::vector<float> values;
  static constexpr std::size_t kFloats = 8;
};

/// What is known around a time: the moments before and after it, or only the one that is nearest
/// (`before`), or none.
struct MomentPair {
  std::shared_ptr<const WaveMoment> before, after;
};

/// Someone who knows moments.
class MomentSource {
 public:
  virtual ~MomentSource() = default;
  /// Waves that will be asked for, from the thread of the GL context, before anybody asks. Those
  /// of the last two calls are remembered.
  virtual void take(const std::shared_ptr<const QueryWaves>& waves) = 0;
  /// Moments `index` and `index` + 1 of these waves. Safe from any thread.
  virtual MomentPair around(const std::shared_ptr<const QueryWaves>& waves, std::int64_t index) = 0;
};

}  // namespace offing
