#include "engine/sky/milky_way.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "engine/core/angles.h"
#include "engine/core/error.h"
#include "engine/core/paths.h"
#include "engine/io/file.h"
#include "engine/sky/stars.h"

namespace offing {

double MilkyWay::luminance(const glm::dvec3& galactic) const {
  const double latitude = std::asin(std::clamp(galactic.z, -1.0, 1.0));
  const double x = wrap_tau(std::atan2(galactic.y, galactic.x)) / kTau * width - 0.5;
  const double y = 0.5 * (1.0 - latitude / kReach) * height - 0.5;
  const double column = std::floor(x), row = std::floor(y);
  const auto value = [&](double c, double r) {
    if (r < 0.0 || r >= height) return 0.0;
    const int i = (static_cast<int>(c) + width) % width;
    return kUnit * values[static_cast<std::size_t>(static_cast<int>(r) * width + i)];
  };
  return glm::mix(glm::mix(value(column, row), value(column + 1.0, row), x - column),
                  glm::mix(value(column, row + 1.0), value(column + 1.0, row + 1.0), x - column),
                  y - row);
}

glm::dvec3 milky_way_colour() {
  constexpr double kColourIndex = 0.75;  // Leinert et al. 1998, §10.1
  return star_colour(kColourIndex);
}

std::filesystem::path milky_way_file() { return data_root() / "assets/sky/milky_way.pgm"; }

MilkyWay load_milky_way(const std::filesystem::path& file) {
  const std::string bytes = read_text(file, std::size_t{16} << 20);
  const auto refuse = [&](const std::string& why) -> InputError {
    return InputError(fmt::format("{}: {}; fetch it anew or make it with assets/sky/make_sky.py",
                                  file.string(), why));
  };
  MilkyWay map;
  int header = 0;
  // The three lines that make_sky.py writes; PGM would allow comments and other spaces too.
  if (std::sscanf(bytes.c_str(), "P5\n%5d %5d\n255%n", &map.width, &map.height, &header) != 2 ||
      header == 0 || map.width < 2 || map.height < 2) {
    throw refuse("no map of the Milky Way (it must begin with P5, its size and 255)");
  }
  const std::size_t first = static_cast<std::size_t>(header) + 1;
  const std::size_t expected = first + static_cast<std::size_t>(map.width) * map.height;
  if (bytes.size() != expected) {
    throw refuse(fmt::format("{}: {} bytes, but {}×{} need {}",
                             bytes.size() < expected ? "cut short" : "too long", bytes.size(),
                             map.width, map.height, expected));
  }
  map.values.assign(bytes.begin() + static_cast<std::ptrdiff_t>(first), bytes.end());
  return map;
}

glm::dmat3 galactic_from_j2000() {
  const double a = radians(192.85948), d = radians(27.12825);
  const double pole_longitude = radians(90.0 + 32.93192);  // of the north celestial pole
  const glm::dvec3 z(std::cos(d) * std::cos(a), std::cos(d) * std::sin(a), std::sin(d));
  const glm::dvec3 north = glm::normalize(glm::dvec3(0, 0, 1) - z * z.z);
  const glm::dvec3 side = glm::cross(z, north);  // 90 degrees of longitude further
  const glm::dvec3 x = std::cos(pole_longitude) * north - std::sin(pole_longitude) * side;
  return glm::transpose(glm::dmat3(x, glm::cross(z, x), z));
}

}  // namespace offing
