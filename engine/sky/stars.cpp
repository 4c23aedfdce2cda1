#include "engine/sky/stars.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "engine/core/angles.h"
#include "engine/core/random.h"

namespace offing {

std::vector<StarVertex> make_stars() {
  constexpr int kStars = 4800;  // brighter than magnitude 6
  constexpr double kFaintest = 6.0;
  constexpr double kSlope = 0.5;  // counts rise tenfold in two magnitudes
  constexpr double kBrightest = -1.4;
  constexpr std::uint64_t kSeed = 7;
  const glm::dvec3 galactic_pole(std::cos(radians(27.13)) * std::cos(radians(192.86)),
                                 std::cos(radians(27.13)) * std::sin(radians(192.86)),
                                 std::sin(radians(27.13)));
  std::vector<StarVertex> stars;
  for (std::uint64_t i = 0; stars.size() < kStars; ++i) {
    const auto uniform = [&](std::uint64_t stream) { return random_uniform(kSeed, stream, i); };
    const double z = 2.0 * uniform(0) - 1.0, a = kTau * uniform(1);
    const double r = std::sqrt(1.0 - z * z);
    const glm::dvec3 d(r * std::cos(a), r * std::sin(a), z);
    const double latitude = degrees(std::asin(glm::dot(d, galactic_pole)));
    const double density = 0.3 + 0.7 * std::exp(-latitude * latitude / (2.0 * 18.0 * 18.0));
    if (uniform(2) > density) continue;
    const double magnitude =
        std::max(kBrightest, kFaintest + std::log10(std::max(uniform(3), 1e-9)) / kSlope);
    const double warm = std::pow(uniform(4), 1.5);  // most bright stars are white or blue
    glm::dvec3 tint =
        glm::dvec3(0.82, 0.95, 1.30) * (1.0 - warm) + glm::dvec3(1.35, 0.95, 0.62) * warm;
    tint /= glm::dot(tint, glm::dvec3(0.2126, 0.7152, 0.0722));
    stars.push_back(
        {glm::vec4(glm::vec3(d), static_cast<float>(magnitude)), glm::vec4(glm::vec3(tint), 0.0f)});
  }
  return stars;
}

}  // namespace offing
