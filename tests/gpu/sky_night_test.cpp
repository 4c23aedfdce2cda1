// Stars, moon and painted sky as they are drawn.
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "engine/core/angles.h"
#include "engine/environment/calendar.h"
#include "engine/sky/palette.h"
#include "engine/sky/sky.h"
#include "support/sky_graph_test.h"

#define OFFING_GLSL "shaders/lib/phase.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/scattering.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

double luminance(glm::dvec3 c) { return glm::dot(c, glm::dvec3(0.2126, 0.7152, 0.0722)); }

using test::toward;

class SkyNightTest : public test::SkyGraphTest {
 protected:
  void TearDown() override {
    hdr_ = {};
    depth_ = {};
    SkyGraphTest::TearDown();
  }

  struct View {
    int width = 64, height = 36;
    glm::dvec3 forward{0.0, 0.0, -1.0};
    double fov_deg = 60.0;  ///< of the width
    double time = 0.0;      ///< s
  };

  static glm::dvec3 upward(const View& view) {
    return std::abs(view.forward.y) > 0.99 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
  }

  /// Radiance (cd/m^2) of every pixel, bottom row first, and the solid angle of each.
  std::vector<glm::dvec3> draw(const SkyLight& light, const View& view) {
    if (!hdr_ || hdr_.width() != view.width || hdr_.height() != view.height) {
      hdr_ = gl::Texture("hdr", {.format = GL_RGBA32F, .width = view.width, .height = view.height});
      depth_ = gl::Texture(
          "depth", {.format = GL_DEPTH_COMPONENT32F, .width = view.width, .height = view.height});
    }
    shared::FrameData frame =
        test::camera_toward(view.forward, view.fov_deg, view.width, view.height);
    pixel_ = 2.0 * std::tan(radians(view.fov_deg) / 2.0) / view.width;
    frame.time.x = static_cast<float>(view.time);
    const float nothing[4] = {0, 0, 0, 0};
    glClearTexImage(hdr_.id(), 0, GL_RGBA, GL_FLOAT, nothing);
    glClearTexImage(depth_.id(), 0, GL_DEPTH_COMPONENT, GL_FLOAT, nothing);
    const SkyIds ids = begin_frame(frame, light);
    const TextureId hdr = graph_->import(hdr_);
    sky_->add_background(*graph_, light, ids, hdr, graph_->import(depth_),
                         sky_in_view(frame.relative_from_clip, 3.0));
    graph_->add(
        "show", [&](PassBuilder& pass) { pass.read(hdr).side_effect(); }, [](PassContext&) {});
    graph_->execute();
    const std::vector<float> values = hdr_.read_floats(4);
    std::vector<glm::dvec3> picture;
    for (std::size_t i = 0; i < values.size(); i += 4) {
      picture.push_back(glm::dvec3(values[i], values[i + 1], values[i + 2]) / light.exposure);
    }
    return picture;
  }

  /// Lux on a surface that faces it of what stands out of the picture's median, at most `reach`
  /// pixels from the place of `direction`.
  double lux_above_sky(const std::vector<glm::dvec3>& picture, const View& view,
                       const glm::dvec3& direction, double reach = 1e9) const {
    std::vector<double> sorted;
    for (const glm::dvec3& p : picture) sorted.push_back(luminance(p));
    std::nth_element(sorted.begin(),
                     sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
    const double sky = sorted[sorted.size() / 2];
    const glm::dvec3 right = glm::normalize(glm::cross(view.forward, upward(view)));
    const glm::dvec3 above = glm::cross(right, view.forward);
    const double ahead = glm::dot(direction, view.forward) * pixel_;
    const glm::dvec2 place(glm::dot(direction, right) / ahead, glm::dot(direction, above) / ahead);
    double lux = 0.0;
    for (int y = 0; y < view.height; ++y) {
      for (int x = 0; x < view.width; ++x) {
        const glm::dvec2 at(x + 0.5 - 0.5 * view.width, y + 0.5 - 0.5 * view.height);
        if (glm::length(at - place) > reach) continue;
        const double r2 = 1.0 + glm::dot(at, at) * pixel_ * pixel_;
        const double solid_angle = pixel_ * pixel_ / (r2 * std::sqrt(r2));
        const auto i = static_cast<std::size_t>(y * view.width + x);
        lux += (luminance(picture[i]) - sky) * solid_angle;
      }
    }
    return lux;
  }

  gl::Texture hdr_, depth_;
  double pixel_ = 0.0;
};

/// Moonless, without haze, and with Vega near the zenith: 2026-08-13 22:00 UTC off A Coruña.
CelestialState dark_night() {
  return celestial_state(*parse_date("2026-08-13") + *parse_time("22:00"), 43.3623, -8.4115);
}

TEST_F(SkyNightTest, AStarGivesItsLightWhateverThePictureIsLike) {
  const CelestialState s = dark_night();
  const SkyLight light = model_.update(s, 0.0, 3.0);
  const double a = radians(279.2347), d = radians(38.7837);
  const glm::dvec3 vega = s.world_from_j2000 * glm::dvec3(std::cos(d) * std::cos(a),
                                                          std::cos(d) * std::sin(a), std::sin(d));
  ASSERT_GT(vega.y, 0.9);
  // Magnitude 0.03, white, above the air, through clear air; twinkling is 3 % here at most.
  const glsl::vec3 air = glsl::srgb_from_bands(
      glsl::transmittance_to_top(glsl::aerosol_of_haze(0.0), 0.003, vega.y, 1000));
  const double expected =
      kStarLux * std::pow(10.0, -0.4 * 0.03) * luminance(air * star_colour(-0.001));
  std::vector<double> seen;
  for (const auto& [width, fov] : {std::pair{128, 2.0}, {64, 2.0}, {128, 6.0}}) {
    for (int i = 0; i < 6; ++i) {
      // Turned by fractions of a pixel, and so that the star stands aside.
      View view{.width = width, .height = width, .fov_deg = fov};
      const double off = radians(fov / width) * 0.37 * i + radians(fov) * (i % 2 ? 0.3 : 0.0);
      view.forward = glm::normalize(vega + glm::dvec3(off, 0.0, 0.61 * off));
      seen.push_back(lux_above_sky(draw(light, view), view, vega, 6.0) / expected);
      EXPECT_NEAR(seen.back(), 1.0, 0.04) << width << " " << fov << " " << i;
      EXPECT_NEAR(seen.back() / seen.front(), 1.0, 0.01) << width << " " << fov << " " << i;
    }
  }
}

TEST_F(SkyNightTest, AStarIsDrawnWhereItStands) {
  const CelestialState s = dark_night();
  const SkyLight light = model_.update(s, 0.0, 3.0);
  const double a = radians(279.2347), d = radians(38.7837);
  const glm::dvec3 vega = s.world_from_j2000 * glm::dvec3(std::cos(d) * std::cos(a),
                                                          std::cos(d) * std::sin(a), std::sin(d));
  View view{.width = 64, .height = 64, .forward = vega, .fov_deg = 1.0};
  const std::vector<glm::dvec3> picture = draw(light, view);
  glm::dvec2 sum(0.0);
  double weight = 0.0;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const double l = luminance(picture[static_cast<std::size_t>(64 * y + x)]);
      if (l < 0.1) continue;
      sum += l * glm::dvec2(x + 0.5, y + 0.5);
      weight += l;
    }
  }
  ASSERT_GT(weight, 0.0);
  EXPECT_NEAR(sum.x / weight, 32.0, 0.7);  // pixels of 0.016 degrees
  EXPECT_NEAR(sum.y / weight, 32.0, 0.7);
}

TEST_F(SkyNightTest, LowStarsTwinkleAndTheClockDecidesHow) {
  // Antares, 14 degrees up in the south-west. Equal times give equal pictures, others do not.
  const CelestialState s =
      celestial_state(*parse_date("2026-08-13") + *parse_time("21:30"), 43.3623, -8.4115);
  const SkyLight light = model_.update(s, 0.0, 3.0);
  const double a = radians(247.3519), d = radians(-26.4320);
  const glm::dvec3 antares =
      s.world_from_j2000 *
      glm::dvec3(std::cos(d) * std::cos(a), std::cos(d) * std::sin(a), std::sin(d));
  ASSERT_GT(antares.y, 0.05);
  ASSERT_LT(antares.y, 0.4);
  const auto lux = [&](double time) {
    View view{.width = 48, .height = 48, .forward = antares, .fov_deg = 2.0, .time = time};
    return lux_above_sky(draw(light, view), view, antares, 6.0);
  };
  EXPECT_EQ(lux(10.0), lux(10.0));
  double least = 1.0, most = 0.0;
  for (int i = 0; i < 12; ++i) {
    least = std::min(least, lux(10.0 + 0.07 * i));
    most = std::max(most, lux(10.0 + 0.07 * i));
  }
  EXPECT_GT(least, 0.0);
  EXPECT_GT(most / least, 1.15);
}

TEST_F(SkyNightTest, TheMoonsDiscGivesItsLight) {
  // Full, half and crescent, by day so that no disc is held back: the integral of the picture is
  // the model's illuminance, whose law of phases knows nothing of discs.
  for (double phase : {5.0, 60.0, 90.0, 130.0}) {
    CelestialState s;
    s.sun.azimuth_deg = 90.0;
    s.sun.elevation_deg = s.sun.elevation_airless_deg = 30.0;
    s.moon.azimuth_deg = 180.0;
    s.moon.elevation_deg = s.moon.elevation_airless_deg = 40.0;
    s.moon_phase_angle_deg = phase;
    s.moon_lit_fraction = 0.5 + 0.5 * std::cos(radians(phase));
    // The near side faces us; the sun stands `phase` away from us as seen from there.
    const glm::dvec3 to_earth = -toward(180.0, 40.0), east(0.0, 1.0, 0.0);
    const glm::dvec3 aside = glm::normalize(east - to_earth * glm::dot(east, to_earth));
    s.sun_from_moon = std::cos(radians(phase)) * to_earth + std::sin(radians(phase)) * aside;
    s.world_from_moon = glm::dmat3(to_earth, glm::cross(aside, to_earth), aside);
    SkyLight light = model_.update(s, 0.0, 3.0);
    light.sun_source = glm::dvec3(0.0);  // a dark sky, and
    light.star_share = 0.0;              // exposure as by day
    View view{.width = 128, .height = 128, .forward = toward(180.0, 40.0), .fov_deg = 0.8};
    const double lux = lux_above_sky(draw(light, view), view, view.forward);
    const double lit = lux - kPi * light.moon_radius * light.moon_radius * 0.25 *
                                 (1.0 - s.moon_lit_fraction);  // less earthshine
    // The seas lie on one side more than on the other.
    EXPECT_NEAR(lit / luminance(light.moon_illuminance), 1.0, phase < 10.0 ? 0.04 : 0.15) << phase;
  }
}

TEST_F(SkyNightTest, NoRingOfSunlightIsLeftInTotality) {
  // However coarse the pixels are: the moon's edge lies a tenth of a pixel outside the sun's here.
  const auto brightest_shown = [&](const char* time, double fov) {
    const CelestialState s =
        celestial_state(*parse_date("2026-08-12") + *parse_time(time), 43.3623, -8.4115);
    const SkyLight light = model_.update(s, 0.1, 3.0);
    double most = 0.0;
    for (const glm::dvec3& p : draw(light, {.forward = light.sun_direction, .fov_deg = fov})) {
      most = std::max(most, luminance(p) * light.exposure);
    }
    return most;
  };
  for (const double fov : {2.0, 6.0, 40.0}) {
    EXPECT_LT(brightest_shown("18:28", fov), 4.0) << fov;
    EXPECT_GT(brightest_shown("18:20", fov), 40.0) << fov;
  }
}

TEST_F(SkyNightTest, InPlaceOfTheSkyNoTableOfTheAirIsComputed) {
  const CelestialState s =
      celestial_state(*parse_date("2026-08-13") + *parse_time("12:00"), 43.3623, -8.4115);
  SkyLight light = model_.update(s, 0.1, 3.0);
  const PaletteFrame noon = load_palette(find_palette("day")).at(12.0);
  apply_palette(light, noon, PaletteMode::kReplace, 1.0);
  const View up{.forward = {0.0, 1.0, 0.0}, .fov_deg = 4.0};
  const glm::dvec3 zenith = draw(light, up)[0];
  EXPECT_LT(glm::length(zenith - light.painted.zenith), 0.03 * glm::length(zenith));
  for (const char* pass :
       {"sky.transmittance", "sky.multiscatter", "sky.sun_view", "sky.moon_view"}) {
    EXPECT_EQ(row(pass).ran, 0) << pass;
  }
  EXPECT_EQ(row("sky.background").ran, 1);

  light = model_.update(s, 0.1, 3.0);
  const double physical = luminance(draw(light, up)[0]);
  apply_palette(light, noon, PaletteMode::kGrade, 1.0);
  const glm::dvec3 graded = draw(light, up)[0];
  EXPECT_NEAR(luminance(graded) / physical, 1.0, 1e-3);
  EXPECT_LT(glm::length(graded / luminance(graded) - noon.zenith), 0.03);
  EXPECT_EQ(row("sky.sun_view").ran, 1);
}

TEST_F(SkyNightTest, ADayOfFramesHasNoStep) {
  // Every minute of dusk and dawn and some of the rest, away from the sun's and moon's discs: mean
  // luminance as it is shown, whose middle of three may not stand out from its neighbours.
  Ephemeris ephemeris;
  const View view{.forward = toward(0.0, 35.0), .fov_deg = 80.0};
  const auto mean = [&](double minute) {
    const double utc = *parse_date("2026-08-27") + 60.0 * minute;
    const SkyLight& light = model_.update(ephemeris.at(utc, 43.3623, -8.4115), 0.1, 3.0);
    double sum = 0.0;
    for (const glm::dvec3& p : draw(light, view)) {
      EXPECT_TRUE(std::isfinite(luminance(p)) && p.x >= 0.0 && p.y >= 0.0 && p.z >= 0.0) << minute;
      sum += luminance(p);
    }
    return sum / (view.width * view.height) * light.exposure;
  };
  const auto no_step = [&](int from, int to, int stride) {
    double a = mean(from - stride), b = mean(from), worst = 0.0;
    for (int minute = from; minute < to; minute += stride) {
      const double c = mean(minute + stride);
      const double step = std::abs(std::log(b * b / (a * c)));
      EXPECT_LT(step, 0.03) << "minute " << minute;
      worst = std::max(worst, step);
      a = b;
      b = c;
    }
    RecordProperty("worst_from_" + std::to_string(from), std::to_string(worst));
  };
  no_step(1080, 1280, 1);  // the moon rises, the sun sets (19:05 UTC), twilight ends
  no_step(280, 380, 1);    // dawn and sunrise
  no_step(700, 720, 1);    // noon
}

}  // namespace
}  // namespace offing
