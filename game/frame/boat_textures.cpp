#include "game/frame/boat_textures.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <glm/common.hpp>
#include <vector>

namespace offing {
namespace {

// A channel of a picture at (u, v) from its upper left corner, between its pixels.
float smooth_pixel(const Image& image, int channel, float u, float v) {
  const float x = std::clamp(u * static_cast<float>(image.width) - 0.5f, 0.0f,
                             static_cast<float>(image.width - 1));
  const float y = std::clamp(v * static_cast<float>(image.height) - 0.5f, 0.0f,
                             static_cast<float>(image.height - 1));
  const int left = static_cast<int>(x), top = static_cast<int>(y);
  const auto pixel = [&](int column, int row) {
    const int at =
        std::min(row, image.height - 1) * image.width + std::min(column, image.width - 1);
    return image.pixels[static_cast<std::size_t>(at * image.channels + channel)];
  };
  const float s = x - static_cast<float>(left), t = y - static_cast<float>(top);
  return glm::mix(glm::mix(pixel(left, top), pixel(left + 1, top), s),
                  glm::mix(pixel(left, top + 1), pixel(left + 1, top + 1), s), t);
}

}  // namespace

BoatTextures load_boat_textures(const std::filesystem::path& folder) {
  return {.main_alpha = read_image(folder / "main_alpha.png"),
          .main_pattern = read_image(folder / "main_pattern.png"),
          .jib_pattern = read_image(folder / "jib_pattern.png"),
          .flag_alpha = read_image(folder / "flag_alpha.png"),
          .flag_pattern = read_image(folder / "flag_pattern.png")};
}

gl::Texture cloth_texture(const char* label, const Image& pattern, const Image& alpha) {
  gl::Texture texture(label, {.format = GL_RGBA8,
                              .width = pattern.width,
                              .height = pattern.height,
                              .levels = gl::full_mip_levels(pattern.width, pattern.height)});
  std::vector<float> rows;
  for (int y = pattern.height - 1; y >= 0; --y) {  // bottom row first: v grows toward the head
    for (int x = 0; x < pattern.width; ++x) {
      const auto at = static_cast<std::size_t>((y * pattern.width + x) * pattern.channels);
      const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(pattern.width);
      const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(pattern.height);
      const float cloth = alpha.pixels.empty() ? 1.0f : smooth_pixel(alpha, 0, u, v);
      rows.insert(rows.end(),
                  {pattern.pixels[at], pattern.pixels[at + (pattern.channels >= 3)], cloth, 1.0f});
    }
  }
  texture.upload(GL_RGBA, GL_FLOAT, rows.data());
  texture.generate_mipmaps();
  return texture;
}

gl::Texture colour_texture(const Image& image) {
  gl::Texture texture("boat.base_colour",
                      {.format = GL_SRGB8_ALPHA8,
                       .width = image.width,
                       .height = image.height,
                       .levels = gl::full_mip_levels(image.width, image.height)});
  std::vector<float> rgba;
  for (std::size_t i = 0; i < image.pixels.size(); i += static_cast<std::size_t>(image.channels)) {
    const int last = image.channels >= 3 ? 2 : 0;
    rgba.insert(rgba.end(), {image.pixels[i], image.pixels[i + static_cast<std::size_t>(last) / 2],
                             image.pixels[i + static_cast<std::size_t>(last)], 1.0f});
  }
  texture.upload(GL_RGBA, GL_FLOAT, rgba.data());
  texture.generate_mipmaps();
  return texture;
}

}  // namespace offing
