#pragma once
#include "engine/core/fields.h"

namespace offing {

/// How strongly the clouds act on the rest of the scene: scene keys clouds.*. 1 is as in nature.
struct CloudEffects {
  double shafts = 1.0;      ///< light that clouds take out of the air below them
  double rain_rate = 60.0;  ///< of the heaviest rain, mm/h; 0: no veils
  double squalls = 1.0;     ///< the wind that rain brings down
  double lightning = 1.0;   ///< flashes a minute in 100 km² of a full-grown storm; 0: none

  void describe(FieldTable& table);
};

}  // namespace offing
