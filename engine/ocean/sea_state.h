#pragma once
#include "engine/core/fields.h"

namespace offing {

/// Values of SeaState's choices, which are ints so that a FieldTable can bind them.
enum WaveSpectrum : int { kPiersonMoskowitz, kJonswap, kTma };
enum WaveSpreading : int { kCos2s, kMitsuyasu, kHasselmann, kDonelanBanner };

/// Who tells floating things where the water is: FFTW on the CPU, or what the GPU sends back.
enum WaterQueries : int { kDirectQueries, kReadbackQueries };

/// Waves that come from a storm far away, on top of the wind sea.
struct Swell {
  double height = 0.8;      ///< significant height, m; 0 for none
  double period = 10.0;     ///< peak period, s
  double from_deg = 315.0;  ///< degrees true
  double spreading = 75.0;  ///< exponent s of cos^2s(theta / 2): 75 after Goda & Suzuki 1975
};

/// What the sea is made of, apart from the wind, which only the Environment knows.
struct SeaState {
  int spectrum = kJonswap;
  int spreading = kHasselmann;
  double fetch_km = 200.0;
  double depth_m = 1000.0;
  /// How far the wind sea's crests are drawn out like a swell's: xi of Horvath 2015, 0 to 1.
  double elongation = 0.0;
  double choppiness = 1.0;       ///< share of the horizontal motion of linear waves, 1 is physical
  int queries = kDirectQueries;  ///< how, not what: both give the same water
  Swell swell;

  /// The scene keys sea.*, bound to this object.
  void describe(FieldTable& table);
};

}  // namespace offing
