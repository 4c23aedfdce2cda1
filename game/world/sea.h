#pragma once
#include "engine/ocean/direct_water.h"
#include "engine/ocean/spectrum.h"
#include "game/world/scene.h"

namespace offing {

/// The continuous spectrum of a scene's sea, raised by the one wind.
SeaSpectrum sea_spectrum(const Scene& scene);

/// The scene's sea as the exact sum over the waves of its longest bands, `count` of them on grids
/// of `size`²: the slow reference.
DirectWater direct_water(const Scene& scene, int count = 2, int size = 64);

}  // namespace offing
