#pragma once
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <vector>

#include "engine/sky/milky_way.h"
#include "engine/sky/stars.h"

namespace offing {

/// What all stars and the Milky Way together give a surface, without air: the first three orders of
/// spherical harmonics, which hold a clamped cosine to a few per cent (Ramamoorthi & Hanrahan
/// 2001), written as moments of the light. Default: a sky without stars.
class Starlight {
 public:
  Starlight() = default;
  Starlight(const std::vector<Star>& stars, const MilkyWay& milky_way);

  /// Illuminance in lux of a surface with this normal (J2000).
  double illuminance(const glm::dvec3& normal) const;

 private:
  void add(const glm::dvec3& direction, double lux);
  double total_ = 0.0;
  glm::dvec3 first_{0.0};
  glm::dmat3 second_{0.0};
};

}  // namespace offing
