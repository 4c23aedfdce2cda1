#pragma once
#include <glm/vec3.hpp>

#include <cstdint>
#include <memory>

namespace offing {

/// The air by brute force, in double: the oracle of tests and the zero of `bench sky`. Of the code
/// that draws it shares the constants of the air (aerosol_of_haze(), air_at(), phase functions) and
/// nothing else: rays are straight lines in a space of three dimensions, and every optical depth is
/// integrated anew. Bands as there (680, 550, 440 nm), for a light of 1 lux above the air; lengths
/// in km.
class AirReference {
 public:
  explicit AirReference(double haze);

  /// From a height to the top of the air along a ray of this zenith cosine that does not meet the
  /// sea, by Simpson's rule on the ray's chord. Relative error below 1e-5.
  glm::dvec3 transmittance(double height_km, double cosine, int intervals = 400) const;

  /// Radiance toward `view` for a light at `light` (units, y up), light scattered once by
  /// integration in `steps` steps. Nothing of the sea.
  glm::dvec3 single(double height_km, const glm::dvec3& view, const glm::dvec3& light,
                    int steps) const;

  /// The same with all orders, by tracing `paths` paths of photons from the eye for each band, with
  /// a look at the light at each turn (Lambertian sea). `error`, where given: standard error.
  glm::dvec3 path_traced(double height_km, const glm::dvec3& view, const glm::dvec3& light,
                         int paths, std::uint64_t seed, glm::dvec3* error = nullptr) const;

 private:
  double haze_;
};

}  // namespace offing
