#pragma once
#include <span>

#include "engine/ocean/spectrum.h"

namespace offing {

/// Where the summed sea turns white, so that foam that lasts covers the share of the sea that was
/// observed.
struct FoamLaw {
  double birth = 0.0;    ///< Jacobian below which the water breaks
  double present = 0.0;  ///< Jacobian below which a share `white_share` of the sea lies at any time
  double softness = 0.0;  ///< variance by which both edges are softened
  double variance = 0.0;  ///< of the Jacobian of the breaking waves
  double breaking = 0.0;  ///< share of the sea that breaks at any time
};

/// Seconds in which foam fades by a factor e: that of what has just broken and is thick, and that
/// of the thin foam it leaves (Monahan's stages A and B; his whitecaps lived some 3.5 s).
inline constexpr double kFreshSeconds = 0.6, kThinSeconds = 3.5;

/// The Jacobian is 1 + Dxx + Dzz to first order: normal with variance c^2 <|slope|^2>. It falls
/// below a level u deviations under its mean nu = sqrt(rate variance / variance) / 2 pi exp(-u^2/2)
/// times a second (Rice 1944). Foam that fades with time t after each such crossing, at random
/// times, has the mean nu t / (1 + nu t); u is where that and what breaks now make `white_share`.
FoamLaw foam_law(std::span<const Cascade> cascades, double choppiness, double white_share);

}  // namespace offing
