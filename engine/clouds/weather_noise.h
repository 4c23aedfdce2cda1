#pragma once
#include <cstdint>
#include <vector>

namespace offing {

/// What weather is mixed from: a tileable picture of `size`² texels of 4 bytes, row by row. Red:
/// cells and their clusters, green: fronts, blue and alpha: patches of middle and large size. Every
/// channel is evenly distributed over 0 … 255, so that a threshold is a share of the area.
std::vector<std::uint8_t> make_weather_noise(int size);

}  // namespace offing
