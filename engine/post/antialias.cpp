#include "engine/post/antialias.h"

#include <array>

namespace offing {
namespace {

constexpr int kTile = 8;  ///< of outlines_find.comp

}  // namespace

Antialias::Antialias(ShaderLibrary& shaders)
    : find_(shaders.program({"post/outlines_find.comp"})),
      smooth_(shaders.program({"post/outlines_smooth.comp"})),
      show_(shaders.program({"post/outlines_show.comp"})) {}

void Antialias::add(FrameGraph& graph, TextureId solid, TextureId depth, TextureId display) const {
  const gl::TextureDesc& desc = graph.desc(display);
  const auto pixels = static_cast<std::size_t>(desc.width) * static_cast<std::size_t>(desc.height);
  constexpr std::size_t kHeader = 4 * sizeof(std::uint32_t);
  const BufferId list =
      graph.create_buffer("outlines", kHeader + (pixels / 4 + 64) * 2 * sizeof(std::uint32_t));
  graph.add(
      "post.antialias",
      [&](PassBuilder& pass) {
        pass.read(solid).read(depth).modify(display, Access::kImage).write(list);
      },
      [this, solid, depth, display, list](const PassContext& context) {
        const gl::Texture& picture = context.texture(display);
        const gl::Buffer& outlines = context.buffer(list);
        const std::array<std::uint32_t, 4> empty = {0, 1, 1, 0};
        glClearNamedBufferSubData(outlines.id(), GL_RGBA32UI, 0, kHeader, GL_RGBA_INTEGER,
                                  GL_UNSIGNED_INT, empty.data());
        outlines.bind_storage(0);
        for (GLuint unit = 0; unit < 3; ++unit) glBindSampler(unit, 0);
        picture.bind(0);
        context.texture(solid).bind(1);
        context.texture(depth).bind(2);
        find_.use();
        glDispatchCompute(static_cast<GLuint>((picture.width() + kTile - 1) / kTile),
                          static_cast<GLuint>((picture.height() + kTile - 1) / kTile), 1);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
        glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, outlines.id());
        smooth_.use();
        glDispatchComputeIndirect(0);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        picture.bind_image(0, GL_WRITE_ONLY);
        show_.use();
        glDispatchComputeIndirect(0);
        glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, 0);
      });
}

}  // namespace offing
