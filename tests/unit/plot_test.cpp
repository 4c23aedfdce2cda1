#include "game/bench/plot.h"

#include <gtest/gtest.h>

#include <limits>
#include <regex>
#include <string>

namespace offing {
namespace {

int count(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  return static_cast<int>(
      std::distance(std::sregex_iterator(text.begin(), text.end(), regex), std::sregex_iterator()));
}

Plot plot_of(std::vector<glm::dvec2> points) {
  Plot plot{.title = "t", .x_title = "ms", .y_title = "error", .log_x = true, .log_y = true};
  plot.curves = {{.name = "a < b", .points = std::move(points)}};
  return plot;
}

TEST(PlotTest, EqualRatiosAreEqualStepsOnALogarithmicAxis) {
  const std::string svg = svg_of(plot_of({{1, 1}, {10, 10}, {100, 100}}));
  const std::regex mark("<circle cx=\"([0-9.]+)\" cy=\"([0-9.]+)\" r=\"3\"");
  std::vector<double> x, y;
  for (std::sregex_iterator i(svg.begin(), svg.end(), mark), end; i != end; ++i) {
    x.push_back(std::stod((*i)[1]));
    y.push_back(std::stod((*i)[2]));
  }
  ASSERT_EQ(x.size(), 3u);
  EXPECT_NEAR(x[2] - x[1], x[1] - x[0], 0.11);  // written with one decimal
  EXPECT_GT(x[1], x[0]);
  EXPECT_NEAR(y[2] - y[1], y[1] - y[0], 0.11);
  EXPECT_LT(y[1], y[0]);  // up
}

TEST(PlotTest, WhatAnAxisCannotShowIsLeftOut) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::string svg = svg_of(plot_of({{1, 1}, {0, 1}, {2, -1}, {nan, 3}, {4, 2}}));
  EXPECT_EQ(count(svg, "r=\"3\""), 2);
  EXPECT_EQ(count(svg, "nan|inf"), 0);
}

TEST(PlotTest, EmptyAndSinglePointsAreFinitePictures) {
  for (const auto& points : {std::vector<glm::dvec2>{}, std::vector<glm::dvec2>{{5, 5}}}) {
    const std::string svg = svg_of(plot_of(points));
    EXPECT_EQ(count(svg, "nan|inf"), 0);
    EXPECT_EQ(count(svg, "</svg>"), 1);
  }
}

TEST(PlotTest, NamesAreEscaped) { EXPECT_EQ(count(svg_of(plot_of({{1, 1}})), "a &lt; b"), 1); }

}  // namespace
}  // namespace offing
