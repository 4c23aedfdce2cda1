#pragma once
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <filesystem>
#include <vector>

namespace offing {

/// The band of the Milky Way above the glow between its stars: a map in galactic coordinates that
/// ends, dark, at 50 degrees from the galactic plane, so that no pole is in it.
struct MilkyWay {
  int width = 0, height = 0;
  std::vector<std::uint8_t> values;  ///< row 0 in the north; column 0 begins at longitude 0
  static constexpr double kReach = 50.0 * 3.14159265358979 / 180.0;  ///< radians
  static constexpr double kUnit = 2e-6;                              ///< cd/m^2 of a step

  /// Luminance in cd/m^2 above the air toward a unit vector in galactic coordinates.
  double luminance(const glm::dvec3& galactic) const;
};

/// Linear sRGB of luminance 1: many faint suns, a little cooler than ours.
glm::dvec3 milky_way_colour();

/// assets/sky/milky_way.pgm.
std::filesystem::path milky_way_file();

/// Throws InputError, one line that names the file, where it is no such map or cut short.
MilkyWay load_milky_way(const std::filesystem::path& file);

/// From J2000's equator and equinox to galactic coordinates (IAU 1958, as for Hipparcos: pole at
/// 192.85948, 27.12825, ascending node at longitude 32.93192 degrees).
glm::dmat3 galactic_from_j2000();

}  // namespace offing
