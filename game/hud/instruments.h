#pragma once
#include "game/hud/hud.h"

namespace offing {

/// Dial, speed, heading, rudder and sheets, and in words why she isn't moving.
void draw_instruments(const World& world);

}  // namespace offing
