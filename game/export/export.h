#pragma once
#include "game/options.h"

namespace offing {

/// The verb `export`: data of a scene for other tools and for checks. Throws Error.
void run_export(const Options& options);

}  // namespace offing
