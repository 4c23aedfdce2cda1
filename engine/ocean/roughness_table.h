#pragma once
#include <glm/vec4.hpp>

#include <span>
#include <vector>

#include "engine/ocean/spectrum.h"

namespace offing {

/// How many of the cascades, from the longest on, carry waves long enough to break. Ripples do not:
/// with them foam would be dots.
int breaking_cascades(std::span<const Cascade> cascades);

/// The slope variance that ripples of kRippleScale may have, over that of the finest cascade whose
/// picture they are: as much, as long as what no cascade carries of `total` leaves room for it.
double ripple_share(std::span<const Cascade> cascades, const SlopeVariance& total);

/// What the maps do not show of the waves, by the size over which a picture averages them: entry i
/// stands for 2^(kRoughnessFirst + i / kRoughnessSteps) m. x, y, z: slope covariance xx, zz, xz
/// that is missing of `total`; w: share that is missing of the breaking cascades' trace. Counts the
/// levels of the maps, the lines between their points and what fades out before the coarsest level,
/// wave by wave. `ripples`: see ripple_share(), 0 where none are drawn.
std::vector<glm::vec4> roughness_table(std::span<const Cascade> cascades,
                                       const SlopeVariance& total, double ripples = 0.0);

}  // namespace offing
