#pragma once
#include <filesystem>

namespace offing {

/// The folder that holds `shaders/` and `assets/`: $OFFING_ROOT where set, else the nearest folder
/// above the executable that has both, else the source tree this binary was built from.
/// Throws InputError when none has them.
const std::filesystem::path& data_root();

/// "0.1.0"
const char* version();

}  // namespace offing
