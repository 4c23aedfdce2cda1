#include "engine/sky/stars.h"

#include <gtest/gtest.h>
#include <libnova/apparent_position.h>
#include <libnova/transform.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "engine/core/angles.h"
#include "engine/core/error.h"
#include "engine/core/random.h"
#include "engine/environment/calendar.h"
#include "engine/environment/ephemeris.h"
#include "engine/io/file.h"
#include "engine/sky/starlight.h"
#include "support/scratch_folder.h"

namespace offing {
namespace {
namespace fs = std::filesystem;

double utc(const char* date, const char* time) { return *parse_date(date) + *parse_time(time); }

/// J2000 places and brightness as the Bright Star Catalogue prints them.
struct Known {
  const char* name;
  double right_ascension, declination, magnitude, colour;  // degrees
};
constexpr Known kKnown[] = {
    {"Sirius", 101.2872, -16.7161, -1.46, 0.00}, {"Vega", 279.2347, 38.7837, 0.03, 0.00},
    {"Polaris", 37.9529, 89.2641, 2.02, 0.60},   {"Betelgeuse", 88.7929, 7.4071, 0.50, 1.85},
    {"Antares", 247.3519, -26.4320, 0.96, 1.83}, {"Canopus", 95.9880, -52.6957, -0.72, 0.15},
    {"Acrux", 186.6496, -63.0991, 0.8, -0.24}};

glm::dvec3 equatorial(double right_ascension, double declination) {
  const double a = radians(right_ascension), d = radians(declination);
  return {std::cos(d) * std::cos(a), std::cos(d) * std::sin(a), std::sin(d)};
}

const Star& nearest(const std::vector<Star>& stars, const Known& known) {
  const glm::dvec3 d = equatorial(known.right_ascension, known.declination);
  return *std::max_element(stars.begin(), stars.end(), [&](const Star& a, const Star& b) {
    return glm::dot(a.direction, d) < glm::dot(b.direction, d);
  });
}

TEST(Stars, TheCatalogueIsTheNakedEyeSky) {
  const std::vector<Star> stars = load_stars(star_file());
  EXPECT_GT(stars.size(), 4500u);
  for (const Known& known : kKnown) {
    const Star& star = nearest(stars, known);
    const double off =
        glm::length(star.direction - equatorial(known.right_ascension, known.declination));
    EXPECT_LT(degrees(off), 0.01) << known.name;
    EXPECT_NEAR(star.magnitude, known.magnitude, 0.15) << known.name;
    EXPECT_NEAR(star.colour_index, known.colour, 0.4) << known.name;
    EXPECT_NEAR(glm::length(star.direction), 1.0, 1e-12);
  }
  EXPECT_EQ(&nearest(stars, kKnown[0]), &stars[0]);  // Sirius is the brightest
  // Counts to a magnitude (Allen, Astrophysical Quantities, §117): 540 to 4.0, some 4850 to 6.0.
  const auto brighter = [&](double m) {
    return std::count_if(stars.begin(), stars.end(),
                         [&](const Star& s) { return s.magnitude < m; });
  };
  EXPECT_NEAR(static_cast<double>(brighter(4.0)), 515.0, 40.0);
  EXPECT_NEAR(static_cast<double>(brighter(2.0)), 49.0, 4.0);
}

TEST(Stars, StandWhereLibnovaHasThem) {
  // Apparent places (precession, nutation and aberration of 0.006 degrees, which ours leave out) by
  // libnova's own way from J2000 to azimuth and altitude.
  for (unsigned i = 0; i < 40; ++i) {
    const double from = utc("1950-01-01", "00:00"), to = utc("2100-01-01", "00:00");
    const double seconds = from + (to - from) * random_uniform(3, 0, i);
    const double latitude = -85.0 + 170.0 * random_uniform(3, 1, i);
    const double longitude = -180.0 + 360.0 * random_uniform(3, 2, i);
    const CelestialState s = celestial_state(seconds, latitude, longitude);
    const double jd = seconds / 86400.0 + 2440587.5;
    for (const Known& known : {kKnown[0], kKnown[1], kKnown[4]}) {
      ln_equ_posn mean{known.right_ascension, known.declination}, motion{0.0, 0.0}, apparent{};
      ln_get_apparent_posn(&mean, &motion, jd, &apparent);
      ln_lnlat_posn place{longitude, latitude};
      ln_hrz_posn horizontal{};
      ln_get_hrz_from_equ(&apparent, &place, jd, &horizontal);
      SkyPosition theirs;
      theirs.azimuth_deg = horizontal.az + 180.0;  // libnova counts from the south
      theirs.elevation_deg = horizontal.alt;
      const glm::dvec3 ours =
          s.world_from_j2000 * equatorial(known.right_ascension, known.declination);
      EXPECT_LT(degrees(glm::length(ours - theirs.direction())), 0.01)
          << known.name << " " << date_text(seconds) << " " << latitude << " " << longitude;
    }
  }
}

TEST(Stars, PolarisStandsAsHighAsThePlaceIsNorth) {
  for (double latitude : {10.0, 43.3623, 59.3, 80.0}) {
    for (const char* time : {"00:00", "07:00", "15:00"}) {
      const CelestialState s = celestial_state(utc("2026-08-12", time), latitude, -8.4);
      const glm::dvec3 d = s.world_from_j2000 * equatorial(37.9529, 89.2641);
      EXPECT_NEAR(degrees(std::asin(d.y)), latitude, 0.75);
      EXPECT_LT(d.z, 0.0);  // in the north
    }
  }
}

TEST(Stars, TurnWithTheSiderealDayNotTheSolarOne) {
  const double night = utc("2026-08-12", "23:00");
  constexpr double kSiderealDay = 86164.0905;
  const glm::dvec3 vega = equatorial(279.2347, 38.7837);
  const auto at = [&](double seconds) {
    return celestial_state(seconds, 43.0, -8.0).world_from_j2000 * vega;
  };
  EXPECT_LT(degrees(glm::length(at(night + kSiderealDay) - at(night))), 0.001);
  EXPECT_GT(degrees(glm::length(at(night + 86400.0) - at(night))), 0.5);
}

TEST(Stars, ColoursGoFromBlueToRed) {
  const auto ratio = [](double bv) { return star_colour(bv).x / star_colour(bv).z; };
  for (double bv = -0.3; bv < 2.0; bv += 0.1) {
    EXPECT_NEAR(glm::dot(star_colour(bv), glm::dvec3(0.2126, 0.7152, 0.0722)), 1.0, 1e-9);
    EXPECT_GT(ratio(bv + 0.1), ratio(bv)) << bv;
  }
  EXPECT_NEAR(ratio(0.65), 1.0, 0.1);  // as our sun, which is white here
  EXPECT_LT(ratio(-0.2), 0.5);         // Spica
  EXPECT_GT(ratio(1.85), 3.0);         // Betelgeuse
  EXPECT_GE(star_colour(8.0).z, 0.0);
}

struct StarFile : testing::Test {
  std::string refusal() {
    write_text(file, bytes);
    try {
      load_stars(file);
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.find(file.string()), 0u) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      return message;
    }
    ADD_FAILURE() << "was not refused";
    return "";
  }
  /// CRC-32 by its table-free definition as a division of polynomials, bit for bit.
  void sign() {
    std::uint32_t crc = 0xffffffffu;
    for (std::size_t i = 0; i + 4 < bytes.size(); ++i) {
      for (int bit = 0; bit < 8; ++bit) {
        const bool carry = ((crc ^ (static_cast<unsigned char>(bytes[i]) >> bit)) & 1u) != 0;
        crc = (crc >> 1) ^ (carry ? 0xedb88320u : 0u);
      }
    }
    crc = ~crc;
    for (std::size_t i = 0; i < 4; ++i) {
      bytes[bytes.size() - 4 + i] = static_cast<char>((crc >> (8 * i)) & 0xffu);
    }
  }

  const test::ScratchFolder scratch;
  const fs::path file = scratch / "stars.bin";
  std::string bytes = read_text(star_file());
};

TEST_F(StarFile, CutShortAnywhere) {
  const std::string whole = bytes;
  for (std::size_t length : {whole.size() - 1, whole.size() / 2, std::size_t{16}}) {
    bytes = whole.substr(0, length);
    EXPECT_NE(refusal().find("cut short"), std::string::npos) << length;
  }
  for (std::size_t length : {std::size_t{0}, std::size_t{5}, std::size_t{11}}) {
    bytes = whole.substr(0, length);
    EXPECT_NE(refusal().find("no star file"), std::string::npos) << length;
  }
}

TEST_F(StarFile, WrongMagicDamageAndExcess) {
  const std::string whole = bytes;
  bytes[0] = 'X';
  EXPECT_NE(refusal().find("no star file"), std::string::npos);
  bytes = whole;
  bytes[1000] = static_cast<char>(bytes[1000] ^ 1);
  EXPECT_NE(refusal().find("damaged"), std::string::npos);
  bytes = whole + "more";
  EXPECT_NE(refusal().find("too long"), std::string::npos);
  bytes = whole;
  bytes[11] = '\x7f';  // two thousand million stars
  EXPECT_NE(refusal().find("cut short"), std::string::npos);
}

TEST_F(StarFile, AStarThatCannotBe) {
  const std::string whole = bytes;
  sign();
  EXPECT_EQ(bytes, whole);          // the test's checksum is the file's
  bytes[12 + 12 * 7 + 7] = '\x40';  // its declination: far beyond the pole
  sign();
  EXPECT_NE(refusal().find("star 7 cannot be"), std::string::npos);
}

TEST(MilkyWay, LiesWhereItDoes) {
  const glm::dmat3 galactic = galactic_from_j2000();
  // Sagittarius A*, the anticentre, and the two poles (Blaauw et al. 1960, precessed to J2000).
  EXPECT_LT(degrees(glm::length(galactic * equatorial(266.405, -28.936) - glm::dvec3(1, 0, 0))),
            0.01);
  EXPECT_LT(degrees(glm::length(galactic * equatorial(86.405, 28.936) - glm::dvec3(-1, 0, 0))),
            0.01);
  EXPECT_NEAR((galactic * equatorial(192.85948, 27.12825)).z, 1.0, 1e-9);
  EXPECT_NEAR(glm::determinant(galactic), 1.0, 1e-12);

  const MilkyWay map = load_milky_way(milky_way_file());
  const auto at = [&](double right_ascension, double declination) {
    return map.luminance(galactic * equatorial(right_ascension, declination));
  };
  const double sagittarius = at(271.0, -29.0), cygnus = at(303.0, 38.0);
  EXPECT_GT(sagittarius, 2e-4);
  EXPECT_LT(sagittarius, 1e-3);
  EXPECT_GT(cygnus, 1e-4);
  EXPECT_GT(sagittarius, 2.0 * at(86.4, 28.9));  // the anticentre, in Taurus
  EXPECT_EQ(at(192.86, 27.13), 0.0);             // the galactic poles
  EXPECT_EQ(at(12.86, -27.13), 0.0);
  EXPECT_LT(at(222.0, 74.2), 1e-5);  // beside Kochab, in the Little Bear
  // No seam where the longitude starts anew, in front of the galactic centre.
  for (double latitude : {-6.0, -3.0, 0.0, 4.0}) {
    const auto along = [&](double longitude) {
      const double l = radians(longitude), b = radians(latitude);
      return map.luminance({std::cos(b) * std::cos(l), std::cos(b) * std::sin(l), std::sin(b)});
    };
    EXPECT_NEAR(along(-0.01), along(0.01), 0.01 * along(0.0) + 1e-7) << latitude;
  }
}

TEST(MilkyWay, AFileCutShort) {
  const test::ScratchFolder scratch;
  const fs::path file = scratch / "band.pgm";
  const std::string whole = read_text(milky_way_file());
  for (const std::string& bytes : {whole.substr(0, whole.size() - 1), whole.substr(0, 7),
                                   std::string("P6\n2 2\n255\nabcd"), whole + "x"}) {
    write_text(file, bytes);
    EXPECT_THROW(load_milky_way(file), InputError);
  }
}

TEST(Starlight, IsTheSumOfItsStars) {
  const std::vector<Star> stars = load_stars(star_file());
  const MilkyWay map = load_milky_way(milky_way_file());
  const Starlight all(stars, map);
  const glm::dmat3 galactic = galactic_from_j2000();
  for (unsigned i = 0; i < 20; ++i) {
    const double z = 2.0 * random_uniform(5, 0, i) - 1.0, a = kTau * random_uniform(5, 1, i);
    const glm::dvec3 up(std::sqrt(1 - z * z) * std::cos(a), std::sqrt(1 - z * z) * std::sin(a), z);
    double lux = 0.0;
    for (const Star& star : stars) {
      lux += kStarLux * std::pow(10.0, -0.4 * star.magnitude) *
             std::max(glm::dot(up, star.direction), 0.0);
    }
    constexpr int kRings = 90, kAzimuths = 180;
    for (int r = 0; r < kRings; ++r) {
      const double s = -1.0 + (r + 0.5) * 2.0 / kRings;
      for (int k = 0; k < kAzimuths; ++k) {
        const double azimuth = kTau * (k + 0.5) / kAzimuths, c = std::sqrt(1 - s * s);
        const glm::dvec3 d(c * std::cos(azimuth), c * std::sin(azimuth), s);
        lux += map.luminance(galactic * d) * std::max(glm::dot(up, d), 0.0) * (2.0 / kRings) *
               (kTau / kAzimuths);
      }
    }
    EXPECT_NEAR(all.illuminance(up) / lux, 1.0, 0.12) << i;  // three orders of harmonics
    EXPECT_GT(lux, 5e-5);  // a tenth of a millilux or so comes from stars
    EXPECT_LT(lux, 4e-4);
  }
  EXPECT_EQ(Starlight().illuminance({0, 0, 1}), 0.0);
}

}  // namespace
}  // namespace offing
