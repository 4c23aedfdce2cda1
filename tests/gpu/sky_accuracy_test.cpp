// The sky that is drawn against physics worked out without its tables, and against what is
// measured.
#include <fmt/core.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "engine/core/angles.h"
#include "engine/environment/calendar.h"
#include "engine/sky/air_integral.h"
#include "engine/sky/air_reference.h"
#include "engine/sky/sky_panorama.h"
#include "support/sky_graph_test.h"

#define OFFING_GLSL "shaders/lib/colour.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/phase.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/scattering.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/tonemap.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

class SkyAccuracy : public test::SkyGraphTest {
 protected:
  void SetUp() override {
    SkyGraphTest::SetUp();
    if (IsSkipped()) return;
    stars_ = load_stars(star_file());
    model_ = SkyLightModel(Starlight(stars_, load_milky_way(milky_way_file())));
  }

  Panorama panorama(const CelestialState& celestial, double haze, double height, int width) {
    light_ = model_.update(celestial, haze, height);
    return sky_panorama(*shaders_, *graph_, *sky_, light_, 8.0, width, width / 2);
  }

  /// Illuminance of a level surface by sky, discs and stars, lux.
  double level(const CelestialState& celestial) {
    Panorama all = panorama(celestial, 0.1, 3.0, 256);
    add_discs(all, light_);
    add_stars(all, light_, stars_);
    return glm::dot(all.level_illuminance(), glm::dvec3(0.2126, 0.7152, 0.0722));
  }

  std::vector<Star> stars_;
};

CelestialState sun_at(double elevation) { return test::sun_at(180.0, elevation); }

TEST_F(SkyAccuracy, TransmittanceAtAllElevationsAndHeights) {
  light_ = model_.update(sun_at(30.0), 0.0, 3.0);
  graph_->begin_frame();
  const SkyIds ids = sky_->add_tables(*graph_, light_);
  std::vector<float> table;
  int width = 0, height = 0;
  graph_->add(
      "read", [&](PassBuilder& pass) { pass.read(ids.transmittance).side_effect(); },
      [&](PassContext& context) {
        const gl::Texture& texture = context.texture(ids.transmittance);
        table = texture.read_floats(4);
        width = texture.width();
        height = texture.height();
      });
  graph_->execute();
  // As a shader reads it, bilinear, at places that are none of the table's own.
  const auto read = [&](double h, double cosine, int c) {
    const glsl::vec2 unit = glsl::transmittance_units(h, cosine);
    const double x = unit.x * (width - 1), y = unit.y * (height - 1);
    const int i = std::min(static_cast<int>(x), width - 2);
    const int j = std::min(static_cast<int>(y), height - 2);
    const auto at = [&](int a, int b) {
      return static_cast<double>(table[static_cast<std::size_t>(4 * (b * width + a) + c)]);
    };
    const double u = x - i, v = y - j;
    return (1 - v) * ((1 - u) * at(i, j) + u * at(i + 1, j)) +
           v * ((1 - u) * at(i, j + 1) + u * at(i + 1, j + 1));
  };
  const AirReference air(0.0);
  int checked = 0;
  for (const double h : {0.003, 0.03, 0.21, 1.1, 3.7, 8.3, 14.9, 20.0}) {
    const double horizon = -degrees(std::asin(glsl::horizon_dip_sine(h)));
    for (const double above : {0.05, 0.3, 1.1, 2.3, 5.2, 11.0, 31.0, 67.0, 90.0}) {
      const double elevation = std::min(horizon + above, 90.0);
      const double cosine = std::sin(radians(elevation));
      const glm::dvec3 exact = air.transmittance(h, cosine);
      for (int c = 0; c < 3; ++c) {
        if (exact[c] < 0.01) continue;
        EXPECT_NEAR(read(h, cosine, c) / exact[c], 1.0, 0.01) << h << " km " << elevation;
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 150);
}

TEST_F(SkyAccuracy, TheReferenceAgreesWithPublishedTransmittances) {
  // Sea level to 100 km with the constants of Hillaire's demo.
  const AirReference air(0.0);
  const double degrees_up[] = {90.0, 30.0, 10.0, 2.0};
  const glm::dvec3 published[] = {{.94036, .86762, .76231},
                                  {.88478, .75386, .58228},
                                  {.71294, .45938, .22163},
                                  {.33081, .08528, .00616}};
  for (int i = 0; i < 4; ++i) {
    const glm::dvec3 t = air.transmittance(0.0, std::sin(radians(degrees_up[i])));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(t[c] / published[i][c], 1.0, 0.002) << degrees_up[i];
  }
}

TEST_F(SkyAccuracy, DaylightIsThatOfAllOrdersOfScattering) {
  const AirReference air(0.0);
  for (const double elevation : {50.0, 15.0}) {
    Panorama seen = panorama(sun_at(elevation), 0.0, 3.0, 64);
    double error = 0.0, noise = 0.0;
    int count = 0;
    for (const auto& [x, y] : {std::pair{3, 3}, {20, 6}, {10, 9}, {28, 12}, {2, 14}, {24, 15}}) {
      const glm::dvec3 d = seen.direction(x, y);
      glm::dvec3 spread;
      const glm::dvec3 bands = air.path_traced(0.003, d, light_.sun_direction, 1500, 7, &spread);
      const glm::dvec3 traced = glsl::srgb_from_bands(bands);
      for (int c = 0; c < 3; ++c) {
        error += std::abs(seen.at(x, y)[c] / light_.sun_source[c] / traced[c] - 1.0);
        noise += spread[c] / bands[c];
        ++count;
      }
    }
    EXPECT_LT(noise / count, 0.03);
    EXPECT_LT(error / count, 0.05) << elevation;
  }
}

using Pixels = std::vector<glm::dvec3>;

/// Peak signal-to-noise ratio in dB; the peak is the brightest channel of `exact`.
double psnr(const Pixels& seen, const Pixels& exact) {
  double square = 0.0, peak = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const glm::dvec3 error = seen[i] - exact[i];
    square += glm::dot(error, error) / (3.0 * static_cast<double>(exact.size()));
    peak = std::max({peak, exact[i].x, exact[i].y, exact[i].z});
  }
  return 20.0 * std::log10(peak / std::sqrt(square));
}

/// As a display shows it, 0 to 1, at an exposure that suits `meter`.
Pixels displayed(const Pixels& pixels, const Pixels& meter) {
  double mean = 0.0;
  for (const glm::dvec3& p : meter) mean += p.y / static_cast<double>(meter.size());
  Pixels shown;
  for (const glm::dvec3& p : pixels) {
    const glm::dvec3 x = glsl::tonemap_exponential(p / (2.0 * mean));
    shown.emplace_back(glsl::srgb_from_linear(x.x), glsl::srgb_from_linear(x.y),
                       glsl::srgb_from_linear(x.z));
  }
  return shown;
}

TEST_F(SkyAccuracy, RadianceIsThatOfAConvergedIntegration) {
  // The coarsest tables, without the sun's disc, against the same physics in double.
  const AirIntegral air(0.1, 0.9), coarser(0.1, 0.7);
  for (const double elevation : {70.0, 45.0, 20.0, 10.0, 5.0, 2.0, 0.0, -3.0, -6.0}) {
    const double bound = elevation > 10.0 ? 47.0 : 40.0;
    Panorama picture = panorama(sun_at(elevation), 0.1, 3.0, 256);
    Pixels seen, exact, check;
    for (int y = 1; y < 64; y += 2) {  // the last is 0.35 degrees above the level
      for (int x = 4; x < 128; x += 8) {
        const glm::dvec3 d = picture.direction(x, y);
        seen.push_back(picture.at(x, y) / light_.sun_source);
        exact.push_back(glsl::srgb_from_bands(air.radiance(0.003, d, light_.sun_direction)));
        check.push_back(glsl::srgb_from_bands(coarser.radiance(0.003, d, light_.sun_direction)));
      }
    }
    const double converged = psnr(check, exact), radiance = psnr(seen, exact);
    const double shown = psnr(displayed(seen, exact), displayed(exact, exact));
    EXPECT_GT(converged, bound + 5.0) << elevation;
    EXPECT_GT(radiance, bound) << elevation;
    EXPECT_GT(shown, bound) << elevation;
    RecordProperty(fmt::format("sun at {}", elevation),
                   fmt::format("{:.1f} dB, displayed {:.1f}, coarser integration {:.1f}", radiance,
                               shown, converged));
  }
}

TEST_F(SkyAccuracy, TheIntegrationAgreesWithTheReferenceRayByRay) {
  // From where the air is thin most is first order, whose depths the reference integrates
  // anew at each step; the rest is what the path tracer finds beyond it.
  const AirReference reference(0.1);
  const AirIntegral air(0.1, 0.55);
  const glm::dvec3 light = glm::normalize(glm::dvec3(0.3, 0.6, 0.2));
  for (const glm::dvec3 view :
       {glm::dvec3(0.0, 1.0, 0.0), glm::normalize(glm::dvec3(1.0, 0.2, 0.3))}) {
    const glm::dvec3 once = reference.single(20.0, view, light, 200);
    const glm::dvec3 all = air.radiance(20.0, view, light);
    const glm::dvec3 traced = reference.path_traced(20.0, view, light, 3000, 3);
    for (int c = 0; c < 3; ++c) {
      EXPECT_GT(all[c], once[c]);
      EXPECT_NEAR(all[c] / traced[c], 1.0, 0.04) << c;
    }
  }
}

TEST_F(SkyAccuracy, ThePathTracerBeginsWithSingleScattering) {
  // Where the air is thin enough, high up and toward the zenith, first order is all but all of it.
  const AirReference air(0.0);
  const glm::dvec3 light = glm::normalize(glm::dvec3(0.3, 0.6, 0.2));
  const glm::dvec3 up(0.0, 1.0, 0.0);
  const glm::dvec3 once = air.single(40.0, up, light, 200);
  const glm::dvec3 all = air.path_traced(40.0, up, light, 3000, 3);
  EXPECT_GT(all.x, once.x);
  EXPECT_NEAR(all.x / once.x, 1.0, 0.2);
}

TEST_F(SkyAccuracy, TwilightIsThatOfAllOrdersOfScattering) {
  // What the sky gives a level surface with the sun 6 degrees down, the path tracer's paths against
  // the model's tables: directions dense at the horizon, half the azimuths for all.
  constexpr int kCosines = 8, kAzimuths = 6, kPaths = 800;
  const AirReference air(0.1);
  const CelestialState state = sun_at(-6.0);
  const SkyLight& light = model_.update(state, 0.1, 3.0);
  double traced = 0.0;
  for (int i = 0; i < kCosines * kAzimuths; ++i) {
    const double x = (i / kAzimuths + 0.5) / kCosines,
                 azimuth = kPi * (i % kAzimuths + 0.5) / kAzimuths;
    const double cosine = x * x, sine = std::sqrt(1.0 - cosine * cosine);
    const glm::dvec3 view(sine * std::sin(azimuth), cosine, sine * std::cos(azimuth));
    const double weight = kTau * cosine * 2.0 * x / (kCosines * kAzimuths);
    traced += weight * air.path_traced(0.003, view, light.sun_direction, kPaths,
                                       5 + static_cast<std::uint64_t>(i))
                           .y;
  }
  const double ratio = light.sky_illuminance.y / light.sun_source.y / traced;
  EXPECT_NEAR(ratio, 1.0, 0.15);
  RecordProperty("model_over_traced", std::to_string(ratio));
}

TEST_F(SkyAccuracy, LevelIlluminanceIsThatOfNature) {
  const double noon = level(sun_at(62.0));
  EXPECT_GT(noon, 90e3);
  EXPECT_LT(noon, 120e3);
  const double sunset = level(sun_at(-0.3));
  EXPECT_GT(sunset, 300.0);
  EXPECT_LT(sunset, 1000.0);
  // A night with the full moon high, and one without.
  CelestialState night = celestial_state(*parse_date("2026-12-23") + 3600.0 * 23.9, 43.36, -8.41);
  ASSERT_GT(night.moon.elevation_deg, 50.0);
  ASSERT_GT(night.moon_lit_fraction, 0.97);
  const double moonlit = level(night);
  EXPECT_GT(moonlit, 0.05);
  EXPECT_LT(moonlit, 0.35);
  night.moon.elevation_deg = night.moon.elevation_airless_deg = -40.0;
  const double moonless = level(night);
  EXPECT_GT(moonless, 0.5e-3);
  EXPECT_LT(moonless, 2e-3);
}

TEST_F(SkyAccuracy, TheExportedSkyHasTheLightThatTheModelKnows) {
  for (const double elevation : {40.0, 3.0}) {
    // (At 256 the glow round a sun 3° high is still 4 % off.)
    Panorama all = panorama(sun_at(elevation), 0.1, 3.0, 512);
    add_discs(all, light_);
    const glm::dvec3 weights(0.2126, 0.7152, 0.0722);
    EXPECT_NEAR(glm::dot(all.level_illuminance(), weights) / light_.level_illuminance(), 1.0, 0.03)
        << elevation;
  }
}

}  // namespace
}  // namespace offing
