#include "engine/boat/curve.h"

#include <algorithm>
#include <cmath>

#include "engine/core/error.h"

namespace offing {

Curve::Curve(std::initializer_list<std::pair<double, double>> knots, Beyond beyond)
    : beyond_(beyond) {
  if (knots.size() < 2 || knots.size() > kCapacity) {
    throw Error("Curve: takes 2 to 16 knots");
  }
  for (const auto& [x, y] : knots) {
    if (count_ > 0 && !(x > x_[count_ - 1])) throw Error("Curve: knots must increase in x");
    x_[count_] = x;
    y_[count_] = y;
    ++count_;
  }
  std::array<double, kCapacity> secant{};
  for (int i = 0; i + 1 < count_; ++i) secant[i] = (y_[i + 1] - y_[i]) / (x_[i + 1] - x_[i]);
  slope_[0] = secant[0];
  slope_[count_ - 1] = secant[count_ - 2];
  for (int i = 1; i + 1 < count_; ++i) {
    const double left = secant[i - 1], right = secant[i];
    if (left * right <= 0.0) continue;  // an extremum of the table stays one
    // Weighted harmonic mean (Fritsch & Butland 1984): monotone for uneven knots.
    const double h0 = x_[i] - x_[i - 1], h1 = x_[i + 1] - x_[i];
    const double w0 = 2.0 * h1 + h0, w1 = h1 + 2.0 * h0;
    slope_[i] = (w0 + w1) / (w0 / left + w1 / right);
  }
}

double Curve::operator()(double x) const {
  if (!(x > x_[0])) return y_[0];
  const int last = count_ - 1;
  if (x >= x_[last]) {
    return beyond_ == Beyond::kLinear ? y_[last] + slope_[last] * (x - x_[last]) : y_[last];
  }
  int i = 0;
  while (x >= x_[i + 1]) ++i;
  const double h = x_[i + 1] - x_[i], t = (x - x_[i]) / h;
  const double t2 = t * t, t3 = t2 * t;
  return (2.0 * t3 - 3.0 * t2 + 1.0) * y_[i] + (t3 - 2.0 * t2 + t) * h * slope_[i] +
         (3.0 * t2 - 2.0 * t3) * y_[i + 1] + (t3 - t2) * h * slope_[i + 1];
}

double smooth_step(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace offing
