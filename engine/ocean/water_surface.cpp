#include "engine/ocean/water_surface.h"

#include <algorithm>

namespace offing {

void CalmWater::sample(std::span<const glm::dvec2>, double, std::span<WaterSample> out) const {
  std::fill(out.begin(), out.end(), WaterSample{});
}

}  // namespace offing
