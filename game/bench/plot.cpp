#include "game/bench/plot.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace offing {
namespace {

constexpr double kWidth = 800, kHeight = 500;
constexpr double kLeft = 80, kRight = 200, kTop = 40, kBottom = 55;
// Told apart by the colour-blind as well (Okabe & Ito 2008).
constexpr const char* kColours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                    "#56b4e9", "#e69f00", "#000000"};

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '<') {
      result += "&lt;";
    } else if (c == '&') {
      result += "&amp;";
    } else {
      result += c;
    }
  }
  return result;
}

// One axis: from values to pixels, and where its marks stand.
class Axis {
 public:
  Axis(bool logarithmic, double from, double to) : log_(logarithmic), from_(from), to_(to) {}

  bool holds(double value) const { return std::isfinite(value) && (!log_ || value > 0.0); }
  void include(double value) {
    if (!holds(value)) return;
    low_ = std::min(low_, scaled(value));
    high_ = std::max(high_, scaled(value));
  }
  void settle() {
    if (!(low_ <= high_)) low_ = 0.0, high_ = 1.0;
    if (high_ - low_ < 1e-9) low_ -= 0.5, high_ += 0.5;
    const double margin = 0.05 * (high_ - low_);
    // A linear axis that nearly starts at zero starts there.
    const bool from_zero = !log_ && low_ >= 0.0 && low_ < 0.3 * high_;
    low_ = from_zero ? 0.0 : low_ - margin;
    high_ += margin;
  }
  double at(double value) const {
    return from_ + (to_ - from_) * (scaled(value) - low_) / (high_ - low_);
  }
  std::vector<double> marks() const {
    const double span = high_ - low_;
    std::vector<double> result;
    if (log_) {
      for (int decade = static_cast<int>(std::floor(low_)); decade <= high_; ++decade) {
        for (const double digit : {1.0, 2.0, 5.0}) {
          if (digit != 1.0 && span > 2.5) continue;
          const double value = digit * std::pow(10.0, decade);
          if (scaled(value) >= low_ && scaled(value) <= high_) result.push_back(value);
        }
      }
      return result;
    }
    double step = std::pow(10.0, std::floor(std::log10(span / 4.0)));
    if (span / step > 10.0) step *= 2.0;
    if (span / step > 10.0) step *= 2.5;
    for (double value = std::ceil(low_ / step) * step; value <= high_; value += step) {
      result.push_back(std::abs(value) < 1e-9 * step ? 0.0 : value);
    }
    return result;
  }

 private:
  double scaled(double value) const { return log_ ? std::log10(value) : value; }

  bool log_;
  double from_, to_;
  double low_ = std::numeric_limits<double>::max(), high_ = -std::numeric_limits<double>::max();
};

std::string text_at(double x, double y, const char* anchor, const std::string& text,
                    const char* style = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" {}>{}</text>\n", x, y,
                     anchor, style, escaped(text));
}

std::string frame_of(const Plot& plot, const Axis& x, const Axis& y) {
  std::string svg;
  for (const double mark : x.marks()) {
    svg += fmt::format("<path d=\"M{0:.1f} {1}V{2}\" stroke=\"#ddd\"/>\n", x.at(mark), kTop,
                       kHeight - kBottom);
    svg += text_at(x.at(mark), kHeight - kBottom + 16, "middle", fmt::format("{:.4g}", mark));
  }
  for (const double mark : y.marks()) {
    svg += fmt::format("<path d=\"M{1} {0:.1f}H{2}\" stroke=\"#ddd\"/>\n", y.at(mark), kLeft,
                       kWidth - kRight);
    svg += text_at(kLeft - 6, y.at(mark) + 4, "end", fmt::format("{:.4g}", mark));
  }
  svg += fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#444\"/>\n", kLeft,
      kTop, kWidth - kLeft - kRight, kHeight - kTop - kBottom);
  const double middle = 0.5 * (kLeft + kWidth - kRight);
  svg += text_at(middle, 24, "middle", plot.title, "font-size=\"16\"");
  svg += text_at(middle, kHeight - 14, "middle", plot.x_title);
  const double half_way = 0.5 * (kTop + kHeight - kBottom);
  svg += text_at(20, half_way, "middle", plot.y_title,
                 fmt::format("transform=\"rotate(-90 20 {})\"", half_way).c_str());
  return svg;
}

std::string curve_of(const PlotCurve& curve, const char* colour, int row, const Axis& x,
                     const Axis& y) {
  std::string path, marks;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const glm::dvec2 point = curve.points[i];
    if (!x.holds(point.x) || !y.holds(point.y)) continue;
    const double px = x.at(point.x), py = y.at(point.y);
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", px, py);
    marks +=
        fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"/>\n", px, py, colour);
    if (i < curve.labels.size()) {
      marks += text_at(px + 6, py - 4, "start", curve.labels[i], "font-size=\"10\"");
    }
  }
  std::string svg;
  if (curve.joined && !path.empty()) {
    svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>\n", path,
                       colour);
  }
  const double key_y = kTop + 12 + 18 * row;
  svg += marks;
  svg += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"4\" fill=\"{}\"/>\n", kWidth - kRight + 14,
                     key_y - 4, colour);
  return svg + text_at(kWidth - kRight + 24, key_y, "start", curve.name);
}

std::string body_of(const Plot& plot) {
  Axis x(plot.log_x, kLeft, kWidth - kRight), y(plot.log_y, kHeight - kBottom, kTop);
  for (const PlotCurve& curve : plot.curves) {
    for (const glm::dvec2& point : curve.points) {
      if (!x.holds(point.x) || !y.holds(point.y)) continue;
      x.include(point.x);
      y.include(point.y);
    }
  }
  x.settle();
  y.settle();
  std::string svg = frame_of(plot, x, y);
  for (std::size_t i = 0; i < plot.curves.size(); ++i) {
    svg += curve_of(plot.curves[i], kColours[i % std::size(kColours)], static_cast<int>(i), x, y);
  }
  return svg;
}

}  // namespace

std::string svg_of(const std::vector<Plot>& plots) {
  const double height = kHeight * static_cast<double>(plots.size());
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" font-family=\"sans-serif\" font-size=\"12\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n",
      kWidth, height);
  for (std::size_t i = 0; i < plots.size(); ++i) {
    svg += fmt::format("<g transform=\"translate(0 {})\">\n{}</g>\n",
                       kHeight * static_cast<double>(i), body_of(plots[i]));
  }
  return svg + "</svg>\n";
}

std::string svg_of(const Plot& plot) { return svg_of(std::vector<Plot>{plot}); }

}  // namespace offing
