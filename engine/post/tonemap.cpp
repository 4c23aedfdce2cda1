#include "engine/post/tonemap.h"

#include <vector>

namespace offing {
Tonemap::Tonemap(ShaderLibrary& shaders)
    : no_vertices_("tone map"),
      count_("nonfinite pixels", sizeof(std::uint32_t)),
      unexposed_("no exposure", 68 * sizeof(float)),
      no_glow_("no glow", {.format = GL_RGBA16F, .width = 1, .height = 1}),
      linear_("tone map", GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE) {
  // As in shaders/post/exposure.glsl: 64 bins, then stops and factor.
  std::vector<float> state(68, 0.0f);
  state[65] = 1.0f;
  unexposed_.write(state.data(), state.size() * sizeof(float));
  for (int curve = 0; curve < 2; ++curve) {
    for (int night = 0; night < 2; ++night) {
      ShaderDefines defines;
      if (curve == 1) defines.emplace_back("EXPONENTIAL", "1");
      if (night == 1) defines.emplace_back("NIGHT", "1");
      programs_[curve][night] =
          &shaders.program({"post/full_screen.vert", "post/tonemap.frag"}, defines);
    }
  }
  count_.write(std::uint32_t{0});
  glClearTexImage(no_glow_.id(), 0, GL_RGBA, GL_FLOAT, nullptr);
}

const ShaderProgram& Tonemap::program(const TonemapSettings& settings) const {
  return *programs_[settings.curve == ToneCurve::kExponential ? 1 : 0]
                   [settings.exposure > kFirstNight ? 1 : 0];
}

void Tonemap::add(FrameGraph& graph, TextureId hdr, TextureId out, const TonemapSettings& settings,
                  BufferId exposure, TextureId glow) {
  const BufferId count = graph.import(count_);
  const bool glows = glow.valid() && settings.glow_share > 0.0;
  graph.add(
      "post.tonemap",
      [&](PassBuilder& pass) {
        pass.read(hdr).write(out, Access::kAttachment).modify(count).render_to({out});
        if (exposure.valid()) pass.read(exposure);
        if (glows) pass.read(glow);
      },
      [this, hdr, settings, exposure, glow, glows](PassContext& context) {
        const ShaderProgram& tonemap = program(settings);
        glDisable(GL_DEPTH_TEST);
        glDisable(GL_BLEND);
        glDisable(GL_DITHER);
        glBindSampler(0, 0);
        context.texture(hdr).bind(0);
        count_.bind_storage(0);
        (exposure.valid() ? context.buffer(exposure) : unexposed_).bind_storage(1);
        (glows ? context.texture(glow) : no_glow_).bind(1);
        linear_.bind(1);
        tonemap.use();
        tonemap.program().set(0, static_cast<float>(settings.exposure));
        tonemap.program().set(1, glows ? static_cast<float>(settings.glow_share) : 0.0f);
        no_vertices_.bind();
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glBindSampler(1, 0);
      });
}

std::uint32_t Tonemap::take_nonfinite_pixels() {
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  std::uint32_t count = 0;
  count_.read(&count, sizeof(count));
  count_.write(std::uint32_t{0});
  return count;
}

}  // namespace offing
