#pragma once
#include <cstdint>
#include <vector>

#include "engine/environment/environment.h"
#include "engine/ocean/sea_state.h"
#include "engine/ocean/spectrum.h"

namespace offing {

/// One sea state's waves and what the picture needs to know about them.
struct Sea {
  std::vector<Cascade> cascades;
  SeaStatistics statistics;
  SlopeVariance slope_variance;  ///< of the whole sea, down to ripples that no cascade carries
  double choppiness = 1.0;
  double white_share = 0.0;  ///< of the surface
  double wind_speed = 0.0;
  glm::dvec2 wind_to{0.0, 1.0};
};

Sea make_sea(const SeaState& state, const Environment& environment, std::uint64_t seed,
             int cascades, int size);

/// Everything that make_sea() depends on, apart from the grids.
std::uint64_t key_of(const SeaState& state, const Environment& environment, std::uint64_t seed);

/// The sea `seconds` after `from` began to turn into `to` (crossfade.h). Where cascades blend
/// straight their variances are interpolated, between the exact values at both ends.
Sea blend(const Sea& from, const Sea& to, double seconds);

}  // namespace offing
