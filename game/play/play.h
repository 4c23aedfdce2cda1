#pragma once
#include "game/options.h"

namespace offing {

/// The verb `play`: the window, until it is closed. Without a display it says so and renders the
/// scene to offing.png. Throws Error.
void run_play(const Options& options);

}  // namespace offing
