#include "engine/boat/foil.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

#include "engine/boat/curve.h"
#include "engine/boat/hydrostatics.h"
#include "engine/core/angles.h"

namespace offing {

double Foil::lift_slope() const { return kTau * aspect_ / (aspect_ + 2.0); }

FoilCoefficients Foil::coefficients(double angle) const {
  constexpr double kProfileDrag = 0.009, kOswald = 0.9, kSternFirst = 0.8;
  const double a = wrap_pi(angle);
  const bool reversed = std::abs(a) > 0.5 * kPi;
  const double folded = reversed ? kPi - std::abs(a) : std::abs(a);
  const double stalled = smooth_step(radians(14.0), radians(26.0), folded);
  const double attached = lift_slope() * (reversed ? kSternFirst : 1.0) * folded;
  const double lift = attached + (std::sin(2.0 * folded) - attached) * stalled;
  const double clean = attached * attached / (kOswald * kPi * aspect_);
  const double plate = 2.0 * std::sin(folded) * std::sin(folded);
  const double sign = (a < 0.0) != reversed ? -1.0 : 1.0;
  return {sign * lift, kProfileDrag + clean + (plate - clean) * stalled};
}

double Foil::downwash(double angle) const {
  constexpr double kReaches = 0.65;
  const double ahead = std::max(std::cos(angle), 0.0);
  return kReaches * ahead * 2.0 * coefficients(angle).lift / (kPi * aspect_);
}

glm::dvec2 Foil::force(glm::dvec2 flow, double deflection) const {
  const double speed = glm::length(flow);
  if (speed < 1e-9) return glm::dvec2(0.0);
  const glm::dvec2 along = flow / speed;
  const glm::dvec2 across(along.y, -along.x);
  const FoilCoefficients c = coefficients(std::atan2(flow.x, flow.y) - deflection);
  return 0.5 * kWaterDensity * area_ * speed * speed * (c.lift * across + c.drag * along);
}

}  // namespace offing
