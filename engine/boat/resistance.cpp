#include "engine/boat/resistance.h"

#include <algorithm>
#include <cmath>

#include "engine/boat/curve.h"
#include "engine/core/angles.h"

namespace offing {

double upright_resistance(double speed) {
  static const Curve kWholeBoat({{0.0, 0.0},
                                 {2.0, 29.0},
                                 {3.0, 67.0},
                                 {4.0, 126.0},
                                 {4.5, 167.0},
                                 {5.0, 224.0},
                                 {5.5, 296.0},
                                 {6.0, 455.0},
                                 {6.5, 660.0},
                                 {7.0, 931.0},
                                 {7.5, 1248.0},
                                 {8.0, 1554.0}},
                                Curve::Beyond::kLinear);
  constexpr double kFoils = 5.8;
  const double v = knots(speed);
  // Below the first entry friction grows with the square of the speed.
  const double whole = v < 2.0 ? 29.0 * (0.5 * v) * (0.5 * v) : kWholeBoat(v);
  return std::max(whole - kFoils * speed * speed, 0.0);
}

double heeled_resistance(double speed, double heel) {
  static const Curve kAtTwentyDegrees(
      {{3.0, 0.0}, {5.0, 6.0}, {6.0, 25.0}, {7.0, 49.0}, {8.0, 59.0}});
  constexpr double kMostHeel = 60.0;
  const double phi = std::min(std::abs(degrees(heel)), kMostHeel);
  return kAtTwentyDegrees(knots(speed)) * std::pow(phi / 20.0, 1.7);
}

}  // namespace offing
