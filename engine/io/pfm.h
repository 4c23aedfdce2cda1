#pragma once
#include <string>
#include <string_view>

#include "engine/io/image.h"

namespace offing {

/// Pictures may be this many pixels wide and high, and this many values in all (1 GiB).
inline constexpr int kMaxImageSide = 16384;
inline constexpr std::size_t kMaxImageValues = std::size_t{1} << 28;

/// The bytes of a Portable Float Map: "PF" (3 channels) or "Pf" (1), size, byte order, then rows of
/// floats from the bottom up. Little endian is written, both are read. Source: P. Debevec's
/// description of the format, as Netpbm's pfm(5) records it.
std::string encode_pfm(const Image& image);

/// Throws InputError "{name}: …" for anything that is not a whole PFM.
Image decode_pfm(std::string_view bytes, std::string_view name);

}  // namespace offing
