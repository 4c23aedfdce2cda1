#include "engine/ocean/crossfade.h"

#include <algorithm>

namespace offing {
namespace {

struct Ramp {
  double value, rate;
};
// Smooth from 0 to 1 between two times.
Ramp ramp(double seconds, double first, double last) {
  const double part = std::clamp((seconds - first) / (last - first), 0.0, 1.0);
  return {part * part * (3.0 - 2.0 * part), 6.0 * part * (1.0 - part) / (last - first)};
}

}  // namespace

Crossfade crossfade(double seconds, bool same_grid) {
  const double middle = 0.5 * kCrossfadeSeconds;
  const Ramp out = ramp(seconds, 0.0, same_grid ? kCrossfadeSeconds : middle);
  const Ramp in = ramp(seconds, same_grid ? 0.0 : middle, kCrossfadeSeconds);
  return {1.0 - out.value, in.value, -out.rate, in.rate};
}

}  // namespace offing
