#pragma once
#include "engine/io/image.h"

namespace offing {

/// A 4K monitor 0.7 m wide seen from 0.7 m, as in the FLIP paper: 0.7 · 3840 / 0.7 · π / 180.
inline constexpr double kFlipPixelsPerDegree = 67.02064327658226;

/// How different two pictures look when they are flipped between. 0: the same; 1: the most.
struct FlipResult {
  Image error_map;               ///< one channel, 0 to 1, of the pictures' size
  double mean = 0.0;             ///< of the map
  double weighted_median = 0.0;  ///< half of the map's sum lies in pixels below it
  double percentile_99 = 0.0;    ///< the error that 99 of 100 pixels do not exceed
  double maximum = 0.0;
};

/// Exposures of HDR-FLIP, in stops: `count` of them, evenly from `start` to `stop`.
struct FlipExposures {
  double start = 0.0, stop = 0.0;
  int count = 2;
};

/// LDR-FLIP between sRGB-coded pictures (values outside 0 to 1 are clamped) with 3 channels, or 4
/// of which alpha is left out. `pixels_per_degree`: of the viewer's sight, > 0 and at most 1000.
/// Throws InputError for pictures that differ in size, have other channels, are empty, or hold a
/// value that is not finite. Source: P. Andersson et al., "FLIP: A Difference Evaluator for
/// Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020.
FlipResult flip_ldr(const Image& reference, const Image& test,
                    double pixels_per_degree = kFlipPixelsPerDegree);

/// HDR-FLIP between linear pictures (negative values count as 0): the largest LDR-FLIP over a range
/// of exposures, tone-mapped with the ACES curve. Throws as flip_ldr(), and for a reference that is
/// black all over, which has no exposure. Source: P. Andersson et al., "Visualizing Errors in
/// Rendered High Dynamic Range Images", Eurographics Short Papers 2021.
FlipResult flip_hdr(const Image& reference, const Image& test,
                    double pixels_per_degree = kFlipPixelsPerDegree);

/// The same over exposures of the caller's choice: stop ≥ start, both within ±100 stops, count 2 to
/// 1000. Throws InputError for others.
FlipResult flip_hdr(const Image& reference, const Image& test, const FlipExposures& exposures,
                    double pixels_per_degree = kFlipPixelsPerDegree);

/// The exposures that flip_hdr() takes by itself: from the one that just keeps the brightest pixel
/// of the reference to the one that lifts its median, as the paper has it.
FlipExposures flip_exposures(const Image& reference);

}  // namespace offing
