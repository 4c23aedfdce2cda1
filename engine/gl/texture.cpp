#include "engine/gl/texture.h"

#include <algorithm>
#include <atomic>

namespace offing::gl {
namespace {
GLenum target_of(const TextureDesc& desc) {
  if (desc.depth > 0) return GL_TEXTURE_3D;
  return desc.layers > 0 ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
}

GLenum channels_format(int channels) {
  constexpr GLenum kFormats[] = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
  return kFormats[channels - 1];
}
}  // namespace

void delete_texture(GLuint id) { glDeleteTextures(1, &id); }
void delete_sampler(GLuint id) { glDeleteSamplers(1, &id); }

int full_mip_levels(int width, int height) {
  int levels = 1;
  for (int size = std::max(width, height); size > 1; size /= 2) ++levels;
  return levels;
}

Texture::Texture(const std::string& label, const TextureDesc& desc) : desc_(desc) {
  static std::atomic<std::uint64_t> next_serial{1};
  serial_ = next_serial++;
  GLuint id = 0;
  const GLenum target = target_of(desc);
  glCreateTextures(target, 1, &id);
  object_ = Object<delete_texture>(id);
  if (target == GL_TEXTURE_2D) {
    glTextureStorage2D(id, desc.levels, desc.format, desc.width, desc.height);
  } else {
    glTextureStorage3D(id, desc.levels, desc.format, desc.width, desc.height,
                       desc.depth > 0 ? desc.depth : desc.layers);
  }
  // A texture that is read without a sampler object is read texel by texel, clamped.
  glTextureParameteri(id, GL_TEXTURE_MIN_FILTER,
                      desc.levels > 1 ? GL_NEAREST_MIPMAP_NEAREST : GL_NEAREST);
  glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
    glTextureParameteri(id, axis, GL_CLAMP_TO_EDGE);
  }
  glObjectLabel(GL_TEXTURE, id, -1, label.c_str());
}

void Texture::upload(GLenum format, GLenum type, const void* pixels, int level, int layer) const {
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const int w = std::max(1, desc_.width >> level), h = std::max(1, desc_.height >> level);
  if (desc_.depth > 0) {
    glTextureSubImage3D(id(), level, 0, 0, 0, w, h, std::max(1, desc_.depth >> level), format, type,
                        pixels);
  } else if (desc_.layers > 0) {
    glTextureSubImage3D(id(), level, 0, 0, layer, w, h, 1, format, type, pixels);
  } else {
    glTextureSubImage2D(id(), level, 0, 0, w, h, format, type, pixels);
  }
}

void Texture::copy_from(GLuint buffer, GLenum format, GLenum type) const {
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTextureSubImage3D(id(), 0, 0, 0, 0, desc_.width, desc_.height, std::max(desc_.layers, 1),
                      format, type, nullptr);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}

void Texture::generate_mipmaps() const { glGenerateTextureMipmap(id()); }

std::vector<float> Texture::read_floats(int channels, int level) const {
  const auto size = [&](int full) { return static_cast<std::size_t>(std::max(1, full >> level)); };
  const std::size_t slices =
      desc_.depth > 0 ? size(desc_.depth) : static_cast<std::size_t>(std::max(1, desc_.layers));
  std::vector<float> values(size(desc_.width) * size(desc_.height) * slices *
                            static_cast<std::size_t>(channels));
  const bool is_depth = desc_.format == GL_DEPTH_COMPONENT32F;
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureImage(id(), level, is_depth ? GL_DEPTH_COMPONENT : channels_format(channels),
                    GL_FLOAT, static_cast<GLsizei>(values.size() * sizeof(float)), values.data());
  return values;
}

void Texture::blit_to_window(int width, int height) const {
  GLuint source = 0;
  glCreateFramebuffers(1, &source);
  glNamedFramebufferTexture(source, GL_COLOR_ATTACHMENT0, id(), 0);
  glBlitNamedFramebuffer(source, 0, 0, 0, desc_.width, desc_.height, 0, 0, width, height,
                         GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glDeleteFramebuffers(1, &source);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, width, height);
}

void Texture::bind(GLuint unit) const { glBindTextureUnit(unit, id()); }

void Texture::bind_image(GLuint unit, GLenum access, int level) const {
  glBindImageTexture(unit, id(), level, GL_TRUE, 0, access, desc_.format);
}

Sampler::Sampler(const std::string& label, GLenum min_filter, GLenum mag_filter, GLenum wrap_s,
                 GLenum wrap_t) {
  GLuint id = 0;
  glCreateSamplers(1, &id);
  object_ = Object<delete_sampler>(id);
  glSamplerParameteri(id, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(min_filter));
  glSamplerParameteri(id, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(mag_filter));
  glSamplerParameteri(id, GL_TEXTURE_WRAP_S, static_cast<GLint>(wrap_s));
  glSamplerParameteri(id, GL_TEXTURE_WRAP_T, static_cast<GLint>(wrap_t));
  glObjectLabel(GL_SAMPLER, id, -1, label.c_str());
}

void Sampler::bind(GLuint unit) const { glBindSampler(unit, id()); }

}  // namespace offing::gl
