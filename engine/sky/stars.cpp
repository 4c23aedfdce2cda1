#include "engine/sky/stars.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <string_view>

#include "engine/core/angles.h"
#include "engine/core/error.h"
#include "engine/core/paths.h"
#include "engine/io/file.h"

namespace offing {
namespace {

constexpr std::string_view kMagic = "OFFSTAR1";
constexpr std::size_t kHeaderBytes = 12, kStarBytes = 12, kChecksumBytes = 4;
constexpr double kSunTemperature = 5772.0;  // K

/// Little-endian, whatever the machine.
std::uint32_t number(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i) {
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  }
  return value;
}

/// CRC-32 (ISO 3309), bit by bit: 60 kB take a millisecond.
std::uint32_t checksum(std::string_view bytes) {
  std::uint32_t crc = 0xffffffffu;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (0xedb88320u & (0u - (crc & 1u)));
  }
  return ~crc;
}

/// CIE 1931 colour matching functions as sums of Gaussians (Wyman, Sloan & Shirley 2013, eq. 4).
glm::dvec3 matching(double nm) {
  const auto lobe = [nm](double centre, double below, double above) {
    const double t = (nm - centre) * (nm < centre ? below : above);
    return std::exp(-0.5 * t * t);
  };
  return {0.362 * lobe(442.0, 0.0624, 0.0374) + 1.056 * lobe(599.8, 0.0264, 0.0323) -
              0.065 * lobe(501.1, 0.0490, 0.0382),
          0.821 * lobe(568.8, 0.0213, 0.0247) + 0.286 * lobe(530.9, 0.0613, 0.0322),
          1.217 * lobe(437.0, 0.0845, 0.0278) + 0.681 * lobe(459.0, 0.0385, 0.0725)};
}

/// A black body's colour as linear sRGB (IEC 61966-2-1), of any luminance.
glm::dvec3 black_body(double kelvin) {
  constexpr double kSecondRadiation = 1.438777e7;  // nm K
  glm::dvec3 xyz(0.0);
  for (double nm = 380.0; nm <= 780.0; nm += 5.0) {
    const double planck =
        std::pow(nm / 560.0, -5.0) / (std::exp(kSecondRadiation / (nm * kelvin)) - 1.0);
    xyz += planck * matching(nm);
  }
  const glm::dmat3 rgb_from_xyz(3.2406, -0.9689, 0.0557, -1.5372, 1.8758, -0.2040, -0.4986, 0.0415,
                                1.0570);
  return rgb_from_xyz * xyz;
}

double luminance(const glm::dvec3& c) { return glm::dot(c, glm::dvec3(0.2126, 0.7152, 0.0722)); }

}  // namespace

std::filesystem::path star_file() { return data_root() / "assets/sky/stars.bin"; }

std::vector<Star> load_stars(const std::filesystem::path& file) {
  const std::string bytes = read_text(file, std::size_t{16} << 20);
  const auto refuse = [&](const std::string& why) -> InputError {
    return InputError(fmt::format("{}: {}; fetch it anew or make it with assets/sky/make_sky.py",
                                  file.string(), why));
  };
  if (bytes.size() < kHeaderBytes || std::string_view(bytes).substr(0, 8) != kMagic) {
    throw refuse("no star file (it must begin with OFFSTAR1)");
  }
  const std::size_t count = number(bytes, 8, 4);
  const std::size_t expected = kHeaderBytes + count * kStarBytes + kChecksumBytes;
  if (bytes.size() != expected) {
    throw refuse(fmt::format("{}: {} bytes, but {} stars need {}",
                             bytes.size() < expected ? "cut short" : "too long", bytes.size(),
                             count, expected));
  }
  const std::string_view body = std::string_view(bytes).substr(0, expected - kChecksumBytes);
  if (checksum(body) != number(bytes, body.size(), 4)) {
    throw refuse("damaged (its checksum does not fit)");
  }
  std::vector<Star> stars;
  stars.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = kHeaderBytes + i * kStarBytes;
    const double right_ascension = number(bytes, at, 4) * 1e-4;
    const double declination = static_cast<std::int32_t>(number(bytes, at + 4, 4)) * 1e-4;
    const double magnitude = static_cast<std::int16_t>(number(bytes, at + 8, 2)) * 1e-2;
    const double colour = static_cast<std::int16_t>(number(bytes, at + 10, 2)) * 1e-3;
    if (right_ascension >= 360.0 || std::abs(declination) > 90.0 || magnitude < -2.0 ||
        magnitude > 8.0 || std::abs(colour) > 8.0) {
      throw refuse(fmt::format(
          "star {} cannot be: right ascension {:.4f}, declination {:.4f}, magnitude {:.2f}, B-V {}",
          i, right_ascension, declination, magnitude, colour));
    }
    const double a = radians(right_ascension), d = radians(declination);
    stars.push_back(
        {{std::cos(d) * std::cos(a), std::cos(d) * std::sin(a), std::sin(d)}, magnitude, colour});
  }
  return stars;
}

glm::dvec3 star_colour(double colour_index) {
  // Beyond these no normal star is found; reddened ones look no redder than carbon stars do.
  const double bv = glm::clamp(colour_index, -0.4, 2.5);
  const double kelvin = 4600.0 * (1.0 / (0.92 * bv + 1.7) + 1.0 / (0.92 * bv + 0.62));
  static const glm::dvec3 kSun = black_body(kSunTemperature);
  const glm::dvec3 tint = glm::max(black_body(kelvin) / kSun, glm::dvec3(0.0));
  return tint / luminance(tint);
}

}  // namespace offing
