#pragma once
#include "engine/gl/texture.h"

namespace offing {

/// Repeating pictures that make a share of foam into white, with all their levels. They hold
/// deviations from the mean, normally distributed, and so are sums of them: a threshold makes any
/// share of them white.
struct FoamPatterns {
  gl::Texture bubbles;  ///< walls between bubbles, variance 1
  gl::Texture lace;     ///< lace and finer bubbles, weighted: kFoamLace, kFoamBubbles
  gl::Texture rows;     ///< red: torn patches, variance 1; green: streaks, weighted: kStreak…
};
FoamPatterns make_foam_patterns();

}  // namespace offing
