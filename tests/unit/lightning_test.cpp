#include "engine/clouds/lightning.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "engine/clouds/weather_noise.h"

#define OFFING_GLSL "shaders/lib/clouds.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

CloudView storm() {
  CloudView view;
  view.weather.cover = 0.7;
  view.weather.precipitation = 0.8;
  view.weather.type = 1.0;
  view.parameters.effects.lightning = 3.0;
  view.parameters.evolution = 0.0;  // the weather stands, so that its mean rate is known
  return view;
}

TEST(Lightning, StrikesAsOftenAsTheStormsAreLarge) {
  const CloudView view = storm();
  RainCells rain;
  rain.update(view);
  double share = 0.0;  // of the map that is storm
  for (const float falls : rain.rain()) share += glsl::storm_grown(1.0, 0.8, falls);
  share /= static_cast<double>(rain.rain().size());
  ASSERT_GT(share, 0.01);
  const double seconds = 3600.0;
  const double expected = 3.0 / 60.0 * seconds * share * kWeatherPeriod * kWeatherPeriod / 1e8;
  const std::vector<Flash> hour = flashes(rain, view, 0.0, seconds);
  const auto count = static_cast<double>(hour.size());
  EXPECT_NEAR(count, expected, 4.0 * std::sqrt(expected) + 0.03 * expected);
  // As often in each tenth, as scattered as Poisson's: the variance is the mean.
  double square = 0.0;
  for (int i = 0; i < 100; ++i) {
    const double n = static_cast<double>(flashes(rain, view, 36.0 * i, 36.0 * (i + 1)).size());
    square += (n - count / 100.0) * (n - count / 100.0);
  }
  EXPECT_NEAR(square / 99.0 / (count / 100.0), 1.0, 0.5);
  for (const Flash& flash : hour) {
    EXPECT_GT(rain.at(view, flash.begin, flash.at), 0.0);
    EXPECT_GE(flash.begin, 0.0);
    EXPECT_LT(flash.begin, seconds);
  }
}

TEST(Lightning, IsAFunctionOfSeedAndClock) {
  CloudView view = storm();
  RainCells rain;
  rain.update(view);
  const std::vector<Flash> whole = flashes(rain, view, 100.0, 220.0);
  ASSERT_FALSE(whole.empty());
  // In pieces, backward: the same flashes.
  std::size_t count = 0;
  for (double t = 219.0; t >= 100.0; t -= 1.0) count += flashes(rain, view, t, t + 1.0).size();
  EXPECT_EQ(count, whole.size());
  const Flash& one = whole[whole.size() / 2];
  view.elapsed = one.begin + 0.01;
  const FlashView now = flash_now(rain, view);
  EXPECT_GE(now.candela, one.candela(view.elapsed));
  view.elapsed = 5.0;
  flash_now(rain, view);
  view.elapsed = one.begin + 0.01;
  EXPECT_EQ(flash_now(rain, view).candela, now.candela);
  view.seed = 99;
  rain.update(view);
  EXPECT_NE(flashes(rain, view, 100.0, 220.0).size(), 0u);
  EXPECT_NE(flash_now(rain, view).candela, now.candela);
}

TEST(Lightning, FlickersAndIsOverSoon) {
  Flash flash;
  flash.begin = 12.0;
  flash.key = 3;
  EXPECT_EQ(flash.candela(11.999), 0.0);
  EXPECT_GT(flash.candela(12.0), 1e8);
  double most_late = 0.0;
  for (std::uint64_t key = 0; key < 200; ++key) {
    flash.key = key;
    for (double t = 12.0; t < 13.0; t += 0.004) ASSERT_TRUE(std::isfinite(flash.candela(t)));
    most_late = std::max(most_late, flash.candela(12.0 + 0.999 * Flash::kLongest));
    EXPECT_EQ(flash.candela(12.0 + Flash::kLongest), 0.0);
  }
  EXPECT_LT(most_late, 1e-4 * flash.candela(12.0));
}

TEST(Lightning, CostsNothingWithoutStormOrRate) {
  CloudView view = storm();
  RainCells rain;
  EXPECT_TRUE(flashes(rain, view, 0.0, 1000.0).empty());  // no cells yet
  rain.update(view);
  view.parameters.effects.lightning = 0.0;
  EXPECT_TRUE(flashes(rain, view, 0.0, 1000.0).empty());
  view = storm();
  view.weather.precipitation = 0.0;
  rain.update(view);
  EXPECT_TRUE(flashes(rain, view, 0.0, 1000.0).empty());
  EXPECT_EQ(flash_now(rain, view).candela, 0.0);
}

TEST(Lightning, LightsWhatIsFarAwayByTheSquareOfTheDistance) {
  CloudView view = storm();
  view.weather.cover = 0.0;  // by itself
  EXPECT_EQ(flash_light(view, glm::dvec3(0.0)).spread, 0.0);
  view.flash = {{12000.0, 5000.0}, 0.2, 1e9};
  const glm::dvec3 place = flash_place(view);
  const double distance = glm::length(place);
  const FlashLight light = flash_light(view, glm::dvec3(0.0));
  EXPECT_NEAR(glm::dot(light.direction, place), distance, 1e-6 * distance);
  const double luminance =
      glm::dot(light.illuminance, glm::dvec3(0.2126, 0.7152, 0.0722)) * distance * distance;
  EXPECT_NEAR(luminance, 1e9, 0.05e9);
  // Air takes some, and of the way most in its low part.
  const FlashLight hazy = flash_light(view, glm::dvec3(1e-4));
  EXPECT_LT(hazy.illuminance.y, light.illuminance.y);
  EXPECT_GT(hazy.illuminance.y, light.illuminance.y * std::exp(-1e-4 * distance));
}

}  // namespace
}  // namespace offing
