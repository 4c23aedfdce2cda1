#include "game/world/random_sea.h"

#include <algorithm>
#include <cmath>

#include "engine/core/random.h"

namespace offing {

RandomSea random_sea(int seed, int number) {
  std::uint64_t stream = 0;
  const auto uniform = [&] {
    return random_uniform(static_cast<std::uint64_t>(seed), ++stream,
                          static_cast<std::uint64_t>(number));
  };
  const auto between = [&](double low, double high) {
    const double chance = uniform(), part = uniform();
    return chance < 0.0625 ? low : chance > 0.9375 ? high : low + (high - low) * part;
  };
  const auto one_of = [&](int count) {
    return std::min(static_cast<int>(uniform() * count), count - 1);
  };
  RandomSea sea;
  SeaState& s = sea.state;
  s.spectrum = one_of(3);
  s.spreading = one_of(4);
  s.elongation = between(0.0, 1.0);
  s.fetch_km = std::exp(between(0.0, std::log(2000.0)));
  s.depth_m = 0.5 * std::exp(between(0.0, std::log(20000.0)));
  s.choppiness = between(0.0, 1.5);
  s.swell = {.height = between(0.0, 15.0),
             .period = between(3.0, 25.0),
             .from_deg = between(0.0, 360.0),
             .spreading = between(1.0, 500.0)};
  sea.environment.wind.speed = between(0.0, 60.0);
  sea.environment.wind.from_deg = between(0.0, 360.0);
  sea.time = between(0.0, 3.15e7);
  return sea;
}

}  // namespace offing
