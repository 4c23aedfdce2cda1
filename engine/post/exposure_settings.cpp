#include "engine/post/exposure_settings.h"

namespace offing {

void ExposureSettings::describe(FieldTable& table) {
  table.group("exposure")
      .choice("mode", mode, {"auto", "manual"}, "metered as an eye adapts, or fixed")
      .number("ev", ev, {-10.0, 10.0}, "EV", "auto: stops brighter than metered")
      .number("ev100", ev100, {-10.0, 20.0}, "EV", "manual: exposure value at ISO 100")
      .number("darkest", darkest, {-10.0, 0.0}, "EV",
              "auto: most that a bright picture is darkened by")
      .number("brightest", brightest, {0.0, 10.0}, "EV",
              "auto: most that a dark picture is brightened by")
      .number("seconds", seconds, {0.0, 60.0}, "s", "auto: to adapt by two thirds")
      .choice("curve", curve, {"filmic", "exponential"}, "from light to display")
      .number("bloom", bloom, {0.0, 10.0}, "", "glow about bright things: 1 an eye's, 0 none");
}

}  // namespace offing
