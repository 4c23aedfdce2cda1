#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace offing {

/// A PNG made by hand from the format's specification (ISO/IEC 15948), with its pixels in stored,
/// uncompressed deflate blocks (RFC 1950, 1951): what our reader reads shares no code with it.
class PngBytes {
 public:
  /// `rows` is height × (width × channels) values of 8 or 16 bits (the high byte first); channels:
  /// 1 grey, 2 with alpha, 3 RGB, 4 RGBA. At most 65535 bytes in all.
  static std::string make(std::uint32_t width, std::uint32_t height, int channels,
                          std::string_view rows, int bits = 8) {
    std::string filtered;
    const std::size_t stride = rows.size() / (height ? height : 1);
    for (std::size_t y = 0; y < height && stride > 0; ++y) {
      filtered += '\0';  // filter type "none"
      filtered += rows.substr(y * stride, stride);
    }
    std::string header = big_endian(width) + big_endian(height);
    header += static_cast<char>(bits);
    header += "\x00\x04\x02\x06"[channels - 1];
    header += std::string(3, '\0');
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IDAT", stored(filtered)) +
           chunk("IEND", "");
  }

 private:
  static std::string big_endian(std::uint32_t value) {
    return {static_cast<char>(value >> 24), static_cast<char>(value >> 16),
            static_cast<char>(value >> 8), static_cast<char>(value)};
  }
  static std::string chunk(std::string_view type, const std::string& data) {
    const std::string body = std::string(type) + data;
    return big_endian(static_cast<std::uint32_t>(data.size())) + body + big_endian(crc(body));
  }
  static std::uint32_t crc(std::string_view bytes) {
    std::uint32_t value = 0xffffffffu;
    for (const char c : bytes) {
      value ^= static_cast<unsigned char>(c);
      for (int bit = 0; bit < 8; ++bit) value = (value >> 1) ^ (value & 1 ? 0xedb88320u : 0u);
    }
    return ~value;
  }
  static std::string stored(std::string_view bytes) {
    std::uint32_t a = 1, b = 0;  // Adler-32
    for (const char c : bytes) {
      a = (a + static_cast<unsigned char>(c)) % 65521;
      b = (b + a) % 65521;
    }
    const auto size = static_cast<std::uint16_t>(bytes.size());
    const auto inverse = static_cast<std::uint16_t>(~size);
    std::string out = "\x78\x01\x01";
    for (const std::uint16_t word : {size, inverse}) {
      out += static_cast<char>(word & 0xff);
      out += static_cast<char>(word >> 8);
    }
    return out + std::string(bytes) + big_endian(b << 16 | a);
  }
};

}  // namespace offing
