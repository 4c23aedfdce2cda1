#pragma once
#include "game/options.h"

namespace offing {

/// The verb `bench`: run time, and what it buys. Throws Error.
void run_bench(const Options& options);

}  // namespace offing
