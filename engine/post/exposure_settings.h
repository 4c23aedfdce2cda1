#pragma once
#include "engine/core/fields.h"

namespace offing {

enum class ExposureMode : int { kAuto, kManual };

/// How bright the picture is made, and its glow. The scene keys exposure.*.
struct ExposureSettings {
  int mode = static_cast<int>(ExposureMode::kAuto);
  /// Auto: stops brighter than metered. Manual: the exposure value at ISO 100 is `ev100`.
  double ev = 0.0;
  double ev100 = 14.0;
  double darkest = -1.5, brightest = 1.0;  ///< auto: stops about what the eye is used to here
  double seconds = 1.2;                    ///< auto: to adapt by two thirds
  int curve = 0;                           ///< enum class ToneCurve: filmic, exponential
  double bloom = 1.0;                      ///< glow over that of an eye; 0 none

  /// Bound to this object.
  void describe(FieldTable& table);
};

}  // namespace offing
