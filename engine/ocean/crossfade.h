#pragma once

namespace offing {

/// How long (s, of the sea's clock) one sea takes to turn into another.
inline constexpr double kCrossfadeSeconds = 1.0;

/// What is left of the old waves and has come of the new ones, and how fast that changes (1/s).
struct Crossfade {
  double from = 0.0, to = 1.0;
  double from_rate = 0.0, to_rate = 0.0;
};

/// The weights at `seconds` after the start. Waves of one grid and one clock (`same_grid`), which
/// differ in height only, blend straight. Waves of different patches cannot share a map: the old
/// ones calm down first, then the new ones rise. Weights and rates are continuous.
Crossfade crossfade(double seconds, bool same_grid);

}  // namespace offing
