#include "engine/ocean/sea_state.h"

namespace offing {

void SeaState::describe(FieldTable& table) {
  table.group("sea")
      .choice("spectrum", spectrum, {"pm", "jonswap", "tma"},
              "how wave energy is spread over frequency")
      .choice("spreading", spreading, {"cos2", "mitsuyasu", "hasselmann", "donelan-banner"},
              "how wave energy is spread over direction")
      .number("elongation", elongation, {0.0, 1.0}, "",
              "how far crests are drawn out like a swell's (Horvath)")
      .number("fetch", fetch_km, {1.0, 2000.0}, "km", "open water to windward")
      .number("depth", depth_m, {0.5, 10000.0}, "m", "depth of the water")
      .number("choppiness", choppiness, {0.0, 1.5}, "",
              "sideways motion of the water; 1 is that of linear waves")
      .choice("queries", queries, {"direct", "readback"},
              "who computes the water for what floats: the CPU, or the GPU and back");
  table.group("sea.swell")
      .number("height", swell.height, {0.0, 15.0}, "m", "significant height of the swell")
      .number("period", swell.period, {3.0, 25.0}, "s", "peak period of the swell")
      .number("from", swell.from_deg, {0.0, 360.0}, "deg", "where the swell comes from, true")
      .number("spreading", swell.spreading, {1.0, 500.0}, "",
              "exponent s of the swell's cos^2s(angle / 2): the larger the narrower");
}

}  // namespace offing
