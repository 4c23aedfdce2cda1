#pragma once
#include <string>

#include "game/options.h"

namespace offing {

/// Writes the JSON text of a benchmark to options.json, or prints it where none is given.
void deliver_report(const Options& options, const std::string& json);

}  // namespace offing
