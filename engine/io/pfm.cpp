#include "engine/io/pfm.h"

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "engine/core/error.h"

namespace offing {
namespace {

static_assert(std::endian::native == std::endian::little, "floats are copied as they are");

[[noreturn]] void refuse(std::string_view name, std::string_view why) {
  throw InputError(fmt::format("{}: not a whole PFM picture: {}; write it again", name, why));
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

// The next word of the header; what follows it, less one blank, stays in `bytes`.
std::string_view next_word(std::string_view& bytes, std::string_view name) {
  constexpr std::size_t kLongest = 32;
  while (!bytes.empty() && is_blank(bytes.front())) bytes.remove_prefix(1);
  std::size_t size = 0;
  while (size < bytes.size() && size < kLongest && !is_blank(bytes[size])) ++size;
  if (size == 0 || size == kLongest || size == bytes.size())
    refuse(name, "its header is cut short");
  const std::string_view word = bytes.substr(0, size);
  bytes.remove_prefix(size + 1);
  return word;
}

template <class Number>
Number next_number(std::string_view& bytes, std::string_view name) {
  const std::string_view word = next_word(bytes, name);
  Number value{};
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || stop != end) refuse(name, "its header holds no numbers");
  return value;
}

float swapped(float value) {
  return std::bit_cast<float>(__builtin_bswap32(std::bit_cast<std::uint32_t>(value)));
}

}  // namespace

std::string encode_pfm(const Image& image) {
  std::string bytes = fmt::format("{}\n{} {}\n-1.0\n", image.channels == 3 ? "PF" : "Pf",
                                  image.width, image.height);
  const std::size_t row = static_cast<std::size_t>(image.width) * image.channels;
  for (int y = image.height - 1; y >= 0; --y) {
    bytes.append(reinterpret_cast<const char*>(image.pixels.data() + y * row), row * sizeof(float));
  }
  return bytes;
}

Image decode_pfm(std::string_view bytes, std::string_view name) {
  const std::string_view magic = next_word(bytes, name);
  if (magic != "PF" && magic != "Pf") refuse(name, "it does not begin with PF");
  Image image;
  image.channels = magic == "PF" ? 3 : 1;
  image.width = next_number<int>(bytes, name);
  image.height = next_number<int>(bytes, name);
  const auto scale = next_number<double>(bytes, name);
  const bool sound_size = image.width > 0 && image.height > 0 && image.width <= kMaxImageSide &&
                          image.height <= kMaxImageSide;
  if (!sound_size) {
    refuse(name, fmt::format("its size is {}x{}, allowed is 1 to {} on a side", image.width,
                             image.height, kMaxImageSide));
  }
  if (!std::isfinite(scale) || scale == 0.0) refuse(name, "its byte order is not given");
  const std::size_t row = static_cast<std::size_t>(image.width) * image.channels;
  const std::size_t count = row * image.height;
  if (count > kMaxImageValues) refuse(name, "it is larger than 1 GiB");
  if (bytes.size() != count * sizeof(float)) {
    refuse(name, fmt::format("it holds {} bytes of pixels instead of {}", bytes.size(),
                             count * sizeof(float)));
  }
  image.pixels.resize(count);
  for (int y = 0; y < image.height; ++y) {
    std::memcpy(image.pixels.data() + (image.height - 1 - y) * row,
                bytes.data() + y * row * sizeof(float), row * sizeof(float));
  }
  if (scale > 0.0) {
    for (float& value : image.pixels) value = swapped(value);
  }
  return image;
}

}  // namespace offing
