#include "engine/post/bloom.h"

#include <algorithm>
#include <cmath>

namespace offing {
namespace {

constexpr int kMostLevels = 6, kSmallestSide = 4;
// A level's share against all smaller ones: an eye's glare falls off with about the square of the
// angle (Vos & van den Berg 1999), which is the same light in each octave of it.
constexpr float kSmaller = 0.62f;

}  // namespace

Bloom::Bloom(ShaderLibrary& shaders)
    : down_(shaders.program({"post/bloom_down.comp"})),
      up_(shaders.program({"post/bloom_up.comp"})),
      linear_("bloom", GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE) {}

TextureId Bloom::add(FrameGraph& graph, TextureId hdr) {
  const gl::TextureDesc& picture = graph.desc(hdr);
  gl::TextureDesc desc{.format = GL_RGBA16F,
                       .width = std::max((picture.width + 3) / 4, 1),
                       .height = std::max((picture.height + 3) / 4, 1)};
  while (desc.levels < kMostLevels &&
         (std::min(desc.width, desc.height) >> desc.levels) >= kSmallestSide) {
    ++desc.levels;
  }
  const TextureId glow = graph.create("bloom", desc);
  graph.add(
      "post.bloom", [&](PassBuilder& pass) { pass.read(hdr).write(glow); },
      [this, hdr, glow, desc](const PassContext& context) {
        const gl::Texture& texture = context.texture(glow);
        const auto size_of = [&](int level) {
          return glm::ivec2(std::max(desc.width >> level, 1), std::max(desc.height >> level, 1));
        };
        const auto go = [&](const gl::Program& program, int level, glm::vec2 step, int read_level) {
          const glm::ivec2 size = size_of(level);
          program.set(0, glm::vec4(step, static_cast<float>(read_level), 0.0f));
          program.set(1, size);
          glDispatchCompute(static_cast<GLuint>((size.x + 7) / 8),
                            static_cast<GLuint>((size.y + 7) / 8), 1);
        };
        linear_.bind(0);
        down_.use();
        for (int level = 0; level < desc.levels; ++level) {
          (level == 0 ? context.texture(hdr) : texture).bind(0);
          texture.bind_image(0, GL_WRITE_ONLY, level);
          // The four reads lie in the middles of a texel's quarters.
          go(down_.program(), level, 0.25f / glm::vec2(size_of(level)), std::max(level - 1, 0));
          glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
        }
        up_.use();
        up_.program().set(2, kSmaller);
        texture.bind(0);
        for (int level = desc.levels - 2; level >= 0; --level) {
          texture.bind_image(0, GL_READ_WRITE, level);
          go(up_.program(), level, 0.5f / glm::vec2(size_of(level + 1)), level + 1);
          glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
        }
        glBindSampler(0, 0);
      });
  return glow;
}

double glare_share(double exposure) {
  constexpr double kDay = 0.025, kNight = 0.07;
  // Exposures of full daylight and of moonlight, 1e-4 and 1.
  const double night = std::clamp(std::log10(exposure) / 4.0 + 1.0, 0.0, 1.0);
  return kDay + (kNight - kDay) * night;
}

}  // namespace offing
