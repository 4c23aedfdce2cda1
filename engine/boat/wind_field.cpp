#include "engine/boat/wind_field.h"

#include <algorithm>
#include <cmath>

namespace offing {

SteadyWind::SteadyWind(double speed, double from)
    : at_ten_metres_(-speed * std::sin(from), speed * std::cos(from)) {}

glm::dvec2 SteadyWind::velocity(glm::dvec2, double height) const {
  constexpr double kRoughness = 0.005;
  static const double kReference = std::log(10.0 / kRoughness);
  return at_ten_metres_ * (std::log(std::max(height, 0.05) / kRoughness) / kReference);
}

}  // namespace offing
