#include "engine/clouds/cloud_effects.h"

namespace offing {

void CloudEffects::describe(FieldTable& table) {
  table.group("clouds")
      .number("shafts", shafts, {0.0, 1.0}, "",
              "shafts in the air below the clouds: 1 as in nature, 0 none")
      .number("rain_rate", rain_rate, {0.0, 200.0}, "mm/h", "of the heaviest rain; 0: no veils")
      .number("squalls", squalls, {0.0, 2.0}, "", "wind that rain brings down: 1 as in nature")
      .number("lightning", lightning, {0.0, 60.0}, "/min",
              "flashes in 100 km2 of a full-grown storm; 0: none");
}

}  // namespace offing
