#pragma once
#include <array>
#include <initializer_list>
#include <utility>

namespace offing {

/// A measured table made smooth: a monotone piecewise cubic through (x, y) knots, x increasing
/// (Fritsch & Carlson 1980, SIAM J. Numer. Anal. 17). It has no overshoot between knots and a
/// continuous slope, so forces taken from it do not kick. Left of the first knot it is constant;
/// right of the last it is constant, or goes on along the last slope.
class Curve {
 public:
  enum class Beyond { kConstant, kLinear };
  /// 2 to 16 knots.
  Curve(std::initializer_list<std::pair<double, double>> knots, Beyond beyond = Beyond::kConstant);
  double operator()(double x) const;

 private:
  static constexpr int kCapacity = 16;
  std::array<double, kCapacity> x_{}, y_{}, slope_{};
  int count_ = 0;
  Beyond beyond_;
};

/// 0 below `low`, 1 above `high`, Hermite between.
double smooth_step(double low, double high, double x);

}  // namespace offing
