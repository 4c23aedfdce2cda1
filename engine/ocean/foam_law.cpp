#include "engine/ocean/foam_law.h"

#include <algorithm>
#include <cmath>

#include "engine/core/angles.h"
#include "engine/ocean/roughness_table.h"

namespace offing {
namespace {

constexpr double kSoftness = 0.10;  // variance of the edge of foam over that of the Jacobian
constexpr double kHighest = 0.85;   // of a Jacobian that can be called breaking

double normal_below(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

/// The x at which a falling function comes down to a value.
template <class Function>
double where_falls_to(double value, Function&& falling) {
  double low = -1.0, high = 8.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (falling(middle) > value ? low : high) = middle;
  }
  return low;
}

}  // namespace

FoamLaw foam_law(std::span<const Cascade> cascades, double choppiness, double white_share) {
  double trace = 0.0, rate = 0.0;
  for (const Cascade& cascade :
       cascades.first(static_cast<std::size_t>(breaking_cascades(cascades)))) {
    trace += cascade.resolved[0].total();
    rate += cascade.slope_rate;
  }
  FoamLaw law;
  law.variance = choppiness * choppiness * trace;
  law.softness = kSoftness * law.variance + 1e-5;
  const double deviation = std::sqrt(law.variance + law.softness);
  const double crossings = trace > 0.0 ? std::sqrt(rate / trace) / kTau : 0.0;
  const double wanted = std::clamp(white_share, 1e-12, 0.5);
  const double birth = where_falls_to(wanted, [&](double u) {
    const double aged = crossings * std::exp(-0.5 * u * u) * kThinSeconds;
    const double now = normal_below(-u);
    return now + (1.0 - now) * aged / (1.0 + aged);
  });
  const double present = where_falls_to(wanted, [](double u) { return normal_below(-u); });
  law.birth = std::min(1.0 - birth * deviation, kHighest);
  law.present = std::min(1.0 - present * deviation, kHighest);
  law.breaking = std::max(normal_below((law.birth - 1.0) / deviation), 1e-9);
  return law;
}

}  // namespace offing
