#pragma once
#include "game/options.h"

namespace offing {

/// The verb `render`: pictures of a scene without any window. Throws Error.
void run_render(const Options& options);

}  // namespace offing
