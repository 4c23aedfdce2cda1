#include "engine/sky/starlight.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "engine/core/angles.h"

namespace offing {

Starlight::Starlight(const std::vector<Star>& stars, const MilkyWay& milky_way) {
  for (const Star& star : stars) {
    add(star.direction, kStarLux * std::pow(10.0, -0.4 * star.magnitude));
  }
  const glm::dmat3 j2000_from_galactic = glm::transpose(galactic_from_j2000());
  // Cells of some two degrees are enough for moments of the second order.
  constexpr int kLongitudes = 180, kLatitudes = 50;
  for (int j = 0; j < kLatitudes; ++j) {
    const double latitude = MilkyWay::kReach * (2.0 * (j + 0.5) / kLatitudes - 1.0);
    const double solid_angle =
        kTau / kLongitudes * 2.0 * MilkyWay::kReach / kLatitudes * std::cos(latitude);
    for (int i = 0; i < kLongitudes; ++i) {
      const double longitude = kTau * (i + 0.5) / kLongitudes;
      const glm::dvec3 d(std::cos(latitude) * std::cos(longitude),
                         std::cos(latitude) * std::sin(longitude), std::sin(latitude));
      add(j2000_from_galactic * d, solid_angle * milky_way.luminance(d));
    }
  }
}

void Starlight::add(const glm::dvec3& direction, double lux) {
  total_ += lux;
  first_ += lux * direction;
  second_ += lux * glm::outerProduct(direction, direction);
}

double Starlight::illuminance(const glm::dvec3& normal) const {
  // max(t, 0) = 1/4 + t/2 + 5/32 (3 t^2 - 1) + …
  const double squares = glm::dot(normal, second_ * normal);
  return std::max(
      total_ / 4.0 + glm::dot(first_, normal) / 2.0 + 5.0 / 32.0 * (3.0 * squares - total_), 0.0);
}

}  // namespace offing
