#pragma once
#include <string_view>

namespace offing {

/// What one pays for the picture.
struct Quality {
  const char* name;
  int sea_size;        ///< FFT points per side of a cascade
  int sea_mesh;        ///< cells per side of a clipmap ring
  int sky_view_width;  ///< of the sky-view table; its height follows
};

/// low, medium, high, ultra; `auto` is low on a software renderer and high elsewhere.
Quality quality_named(std::string_view name, bool software);

}  // namespace offing
