#include "engine/ocean/water_surface.h"

#include <algorithm>

namespace offing {

double WaterSurface::age(double) const { return 0.0; }

double share_left(double age) {
  const double part =
      std::clamp((age - WaterSurface::kLongestReach) / WaterSurface::kFlattening, 0.0, 1.0);
  return 1.0 - part * part * (3.0 - 2.0 * part);
}

void CalmWater::sample(std::span<const glm::dvec2>, double, std::span<WaterSample> out) const {
  std::fill(out.begin(), out.end(), WaterSample{});
}

}  // namespace offing
