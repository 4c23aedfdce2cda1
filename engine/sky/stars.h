#pragma once
#include <glm/vec3.hpp>

#include <filesystem>
#include <vector>

namespace offing {

/// A star of the catalogue.
struct Star {
  glm::dvec3 direction;  ///< unit vector in the mean equator and equinox of J2000
  double magnitude;      ///< visual
  double colour_index;   ///< B−V, in magnitudes
};

/// Illuminance of a star of magnitude 0 above the air (Allen 1976), lux.
constexpr double kStarLux = 2.54e-6;

/// assets/sky/stars.bin.
std::filesystem::path star_file();

/// All stars of such a file, brightest first. Throws InputError, one line that names the file,
/// where it is no star file, cut short, too long, damaged, or has a star that cannot be.
std::vector<Star> load_stars(const std::filesystem::path& file);

/// Colour of a star as linear sRGB of luminance 1: a black body of the temperature that its B−V
/// stands for (Ballesteros 2012), seen by the CIE 1931 observer, with the sun as white.
glm::dvec3 star_colour(double colour_index);

}  // namespace offing
