#pragma once
#include <cmath>
#include <numbers>

namespace offing {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kTau = 2.0 * std::numbers::pi;
inline constexpr double kGravity = 9.81;  ///< m/s^2, as in every spectrum here
inline constexpr double kMetresPerSecondPerKnot = 1852.0 / 3600.0;

constexpr double radians(double degrees) { return degrees * (kPi / 180.0); }
constexpr double degrees(double radians) { return radians * (180.0 / kPi); }
constexpr double knots(double metres_per_second) {
  return metres_per_second / kMetresPerSecondPerKnot;
}
constexpr double metres_per_second(double knots) { return knots * kMetresPerSecondPerKnot; }

/// The same angle in [-pi, pi).
inline double wrap_pi(double angle) { return angle - kTau * std::floor((angle + kPi) / kTau); }
/// The same angle in [0, 2 pi).
inline double wrap_tau(double angle) { return angle - kTau * std::floor(angle / kTau); }

}  // namespace offing
