#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "engine/gl/object.h"

namespace offing::gl {

void delete_texture(GLuint id);
void delete_sampler(GLuint id);

/// Shape and format of a texture; `layers` > 0 makes a 2-D array, `depth` > 0 a 3-D texture.
struct TextureDesc {
  GLenum format = GL_RGBA16F;
  int width = 1, height = 1;
  int layers = 0;
  int depth = 0;
  int levels = 1;
  bool operator==(const TextureDesc&) const = default;
};

/// Number of levels down to 1×1.
int full_mip_levels(int width, int height);

/// An immutable texture.
class Texture {
 public:
  Texture() = default;
  Texture(const std::string& label, const TextureDesc& desc);

  GLuint id() const { return object_.id(); }
  /// Never the same for two textures of a run, unlike id().
  std::uint64_t serial() const { return serial_; }
  const TextureDesc& desc() const { return desc_; }
  int width() const { return desc_.width; }
  int height() const { return desc_.height; }
  explicit operator bool() const { return static_cast<bool>(object_); }

  /// Fills one level (of one layer, where there are any) from tightly packed client memory.
  void upload(GLenum format, GLenum type, const void* pixels, int level = 0, int layer = 0) const;
  /// Fills all layers of level 0 from a buffer, tightly packed.
  void copy_from(GLuint buffer, GLenum format, GLenum type) const;
  void generate_mipmaps() const;
  /// All channels of one level as floats, row 0 first; synchronous: for tests and exports.
  std::vector<float> read_floats(int channels, int level = 0) const;

  /// Copies level 0 to the window's framebuffer of this size, and leaves that bound.
  void blit_to_window(int width, int height) const;

  void bind(GLuint unit) const;
  /// All layers at once, level `level`.
  void bind_image(GLuint unit, GLenum access, int level = 0) const;

 private:
  Object<delete_texture> object_;
  TextureDesc desc_;
  std::uint64_t serial_ = 0;
};

/// How a texture is read, apart from the texture.
class Sampler {
 public:
  Sampler() = default;
  Sampler(const std::string& label, GLenum min_filter, GLenum mag_filter, GLenum wrap_s,
          GLenum wrap_t);
  GLuint id() const { return object_.id(); }
  void bind(GLuint unit) const;

 private:
  Object<delete_sampler> object_;
};

}  // namespace offing::gl
