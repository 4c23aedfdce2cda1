#pragma once
#include <glm/vec2.hpp>

#include <string>
#include <vector>

namespace offing {

/// A curve or, where not `joined`, marks alone.
struct PlotCurve {
  std::string name;
  std::vector<glm::dvec2> points;
  std::vector<std::string> labels = {};  ///< beside the points; may be fewer than these
  bool joined = true;
};

/// Curves over two axes, each linear or logarithmic.
struct Plot {
  std::string title, x_title, y_title;
  bool log_x = false, log_y = false;
  std::vector<PlotCurve> curves = {};
};

/// The plot as an SVG picture, 800 × 500. Points that are not finite, and on a logarithmic axis
/// those not above zero, are left out.
std::string svg_of(const Plot& plot);

/// Several plots, one below the other.
std::string svg_of(const std::vector<Plot>& plots);

}  // namespace offing
