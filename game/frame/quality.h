#pragma once
#include <string_view>

namespace offing {

/// What one pays for the picture.
struct Quality {
  const char* name;
  int level;  ///< 0 low to 3 ultra: what each technique makes its own sizes of
};

/// low, medium, high or ultra; anything else (`auto`) is low on a software renderer and high
/// elsewhere.
Quality quality_named(std::string_view name, bool software);

}  // namespace offing
