#include "engine/post/tonemap.h"

#include <vector>

namespace offing {
namespace {
/// Below this exposure the brightest thing that rods help to see (3 cd/m^2) is under half a step of
/// an 8-bit display.
constexpr double kFirstNight = 5e-5;
}  // namespace

Tonemap::Tonemap(ShaderLibrary& shaders)
    : no_vertices_("tone map"),
      count_("nonfinite pixels", sizeof(std::uint32_t)),
      unexposed_("no exposure", 68 * sizeof(float)),
      linear_("tone map", GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE) {
  // As in shaders/post/exposure.glsl: 64 bins, then stops and factor.
  std::vector<float> state(68, 0.0f);
  state[65] = 1.0f;
  unexposed_.write(state.data(), state.size() * sizeof(float));
  for (int curve = 0; curve < 2; ++curve) {
    for (int counts = 0; counts < 2; ++counts) {
      ShaderDefines defines;
      if (curve == 1) defines.emplace_back("EXPONENTIAL", "1");
      if (counts == 1) defines.emplace_back("COUNT_NONFINITE", "1");
      programs_[curve][counts] =
          &shaders.program({"post/full_screen.vert", "post/tonemap.frag"}, defines);
    }
  }
  count_.write(std::uint32_t{0});
}

const ShaderProgram& Tonemap::program(const TonemapSettings& settings) const {
  return *programs_[settings.curve == ToneCurve::kExponential ? 1 : 0]
                   [settings.count_nonfinite ? 1 : 0];
}

void Tonemap::add(FrameGraph& graph, TextureId hdr, TextureId out, const TonemapSettings& settings,
                  BufferId exposure, TextureId glow) {
  const BufferId count = graph.import(count_);
  const bool glows = glow.valid() && settings.glow_share > 0.0;
  graph.add(
      "post.tonemap",
      [&](PassBuilder& pass) {
        pass.read(hdr).write(out, Access::kAttachment).render_to({out});
        if (settings.count_nonfinite) pass.modify(count);
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
        if (settings.count_nonfinite) count_.bind_storage(0);
        (exposure.valid() ? context.buffer(exposure) : unexposed_).bind_storage(1);
        if (glows) context.texture(glow).bind(1);
        linear_.bind(1);
        tonemap.use();
        tonemap.program().set(0, static_cast<float>(settings.exposure));
        tonemap.program().set(1, settings.exposure > kFirstNight ? 1 : 0);
        tonemap.program().set(2, glows ? static_cast<float>(settings.glow_share) : 0.0f);
        tonemap.program().set(3, glows ? 1 : 0);
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
