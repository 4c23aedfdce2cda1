#include "game/frame/renderer.h"

#include <epoxy/gl.h>

#include <cmath>

#include "engine/core/paths.h"

namespace offing {
namespace {

// Rows from the bottom, as GL has them, to rows from the top, and three channels of `channels`.
Image top_down_rgb(const std::vector<float>& values, int width, int height, int channels,
                   float scale) {
  Image image{width, height, 3, std::vector<float>(static_cast<std::size_t>(width) * height * 3)};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t from = (static_cast<std::size_t>(height - 1 - y) * width + x) * channels;
      const std::size_t to = (static_cast<std::size_t>(y) * width + x) * 3;
      for (std::size_t c = 0; c < 3; ++c) image.pixels[to + c] = values[from + c] * scale;
    }
  }
  return image;
}

}  // namespace

Renderer::Renderer(const Quality& quality, const std::filesystem::path& boat_model)
    : quality_(quality),
      shaders_(data_root() / "shaders"),
      graph_(device_),
      techniques_(shaders_, quality, boat_model) {}

void Renderer::prime(double time) {
  techniques_.ocean.prime(graph_, time);
  graph_.reset_report();
}

void Renderer::resize(glm::ivec2 size) {
  if (size != glm::ivec2(pictures_.hdr.width(), pictures_.hdr.height()))
    pictures_ = FramePictures(size);
}

void Renderer::build(const FrameView& view,
                     const std::function<void(const gl::Texture& picture)>& present) {
  resize(view.size);
  graph_.begin_frame();
  const TextureId picture = build_frame(graph_, view, techniques_, pictures_);
  graph_.add(
      "screen.present",
      [&](PassBuilder& pass) { pass.read(picture, Access::kTransfer).side_effect(); },
      [present, picture](PassContext& context) { present(context.texture(picture)); });
}

void Renderer::execute() {
  graph_.execute();
  techniques_.ocean.collect();
}

SeaMeasurement Renderer::measure_sea() const {
  const Ocean& ocean = techniques_.ocean;
  return offing::measure_sea(ocean.cascades(), ocean.maps().displacement().read_floats(4));
}

Image Renderer::picture() const {
  const gl::Texture& display = pictures_.display;
  return top_down_rgb(display.read_floats(4), display.width(), display.height(), 4, 1.0f);
}

Image Renderer::radiance(double exposure) const {
  const gl::Texture& hdr = pictures_.hdr;
  return top_down_rgb(hdr.read_floats(4), hdr.width(), hdr.height(), 4,
                      static_cast<float>(1.0 / exposure));
}

}  // namespace offing
