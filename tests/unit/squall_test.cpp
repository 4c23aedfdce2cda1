#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "engine/clouds/rain_cells.h"
#include "engine/environment/environment.h"
#include "game/world/clouds.h"

namespace offing {
namespace {

constexpr int kSize = 64;
constexpr double kPeriod = 32000.0;

/// One round cell of rain in the middle of the grid.
std::vector<float> one_cell() {
  std::vector<float> rain;
  for (int j = 0; j < kSize; ++j) {
    for (int i = 0; i < kSize; ++i) {
      const double r = std::hypot(i - 31.5, j - 31.5) * kPeriod / kSize;
      rain.push_back(static_cast<float>(std::exp(-r * r / (2.0 * 1500.0 * 1500.0))));
    }
  }
  return rain;
}

TEST(Squalls, OutflowLeavesTheCellOnAllSides) {
  const SquallField field(one_cell(), kSize, kPeriod, {0.0, 0.0}, 1.0);
  const glm::dvec2 middle(kPeriod / 2.0);
  double fastest = 0.0;
  for (double a = 0.0; a < 6.28; a += 0.3) {
    const glm::dvec2 out(std::cos(a), std::sin(a));
    const glm::dvec2 v = field.added(middle + 2500.0 * out);
    EXPECT_GT(glm::dot(v, out), 0.98 * glm::length(v));
    fastest = std::max(fastest, glm::length(v));
  }
  EXPECT_LE(fastest, SquallField::kOutflow);
  EXPECT_GT(fastest, 0.7 * SquallField::kOutflow);
  EXPECT_LT(glm::length(field.added(middle)), 0.05 * SquallField::kOutflow);
  // Far from it there is next to nothing, and the field repeats.
  EXPECT_LT(glm::length(field.added(glm::dvec2(0.0))), 0.1 * SquallField::kOutflow);
  EXPECT_NEAR(field.added({1000.0, 700.0}).x, field.added({1000.0 - kPeriod, 700.0}).x, 1e-9);
  EXPECT_NEAR(field.added({1000.0, 700.0}).x, field.added({1000.0, 700.0 + 3 * kPeriod}).x, 1e-9);
}

TEST(Squalls, UnderTheCellTheWindIsStrongerAndThePictureSaysSo) {
  Environment environment;
  environment.wind = {.speed = 9.0, .from_deg = 250.0, .gusts = 0.0};
  const SquallField field(one_cell(), kSize, kPeriod, environment.wind_velocity(), 1.0);
  environment.set_squalls(std::make_shared<SquallField>(field));
  environment.set_squall_corner({-5000.0, 300.0});
  const glm::dvec2 middle = glm::dvec2(-5000.0, 300.0) + kPeriod / 2.0;
  EXPECT_GT(glm::length(environment.wind_at(middle, 10.0)), 1.2 * 9.0);
  // The front runs ahead of it.
  const glm::dvec2 front = middle + 2500.0 * environment.wind_to();
  EXPECT_GT(glm::length(environment.wind_at(front, 10.0)), 1.5 * 9.0);
  // What the water is drawn by is that same wind.
  for (const std::size_t cell : {100u, 2080u, 2100u, 3000u}) {
    const glm::dvec2 place = (glm::dvec2(cell % kSize, cell / kSize) + 0.5) * (kPeriod / kSize) +
                             environment.squall_corner();
    EXPECT_NEAR(glm::length(environment.wind_at(place, 10.0)) / 9.0 - 1.0,
                static_cast<double>(field.strength()[cell]), 1e-5);
  }
}

TEST(Squalls, NoRainNoSquall) {
  EXPECT_FALSE(
      SquallField(std::vector<float>(kSize * kSize, 0.0f), kSize, kPeriod, {9.0, 0.0}, 1.0).any());
  EXPECT_FALSE(SquallField(one_cell(), kSize, kPeriod, {9.0, 0.0}, 0.0).any());
  RainCells cells;
  CloudView view;
  cells.update(view);
  EXPECT_FALSE(cells.any());
}

TEST(Squalls, CellsDriftWithTheCloudsAndBelongToTheWorld) {
  RainCells cells;
  CloudView view;
  view.weather.cover = 0.6;
  view.weather.precipitation = 0.6;
  view.elapsed = 21.0;
  EXPECT_TRUE(cells.update(view));
  ASSERT_TRUE(cells.any());
  EXPECT_FALSE(cells.update(view));
  const glm::dvec2 before = cells.middle(view, 777);
  // Another eye sees the same cell at the same place; the wind carries it.
  view.eye = {400.0, 3.0, -250.0};
  EXPECT_NEAR(glm::length(cells.middle(view, 777) - before), 0.0, 1e-6);
  view.drift += glm::dvec2(0.0, 50.0);
  EXPECT_GT((cells.middle(view, 777) - before).y, 50.0);
}

}  // namespace
}  // namespace offing
