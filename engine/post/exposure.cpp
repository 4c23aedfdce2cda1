#include "engine/post/exposure.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace offing {
namespace {

/// As in shaders/post/exposure.glsl.
struct State {
  std::uint32_t histogram[64];
  float stops, factor, metered;
  std::uint32_t adapted;
};

// The dark sea under the sky that an eye is used to: a picture's middle is this much darker.
constexpr double kPictureOverLight = 0.35;
// Half of how far the picture is off its middle is made up for: dusk stays dusk.
constexpr float kFollowed = 0.5f;
constexpr glm::vec2 kCounted{0.2f, 0.95f};
// Eyes get used to light faster than to darkness.
constexpr double kFaster = 3.0;

}  // namespace

Exposure::Exposure(ShaderLibrary& shaders)
    : meter_(shaders.program({"post/meter.comp"})), adapt_(shaders.program({"post/adapt.comp"})) {
  State start{};
  start.factor = 1.0f;
  state_ = gl::Buffer("exposure", sizeof(State), GL_DYNAMIC_STORAGE_BIT, &start);
}

BufferId Exposure::add(FrameGraph& graph, TextureId hdr, const PictureLight& light,
                       const ExposureSettings& settings) {
  const BufferId state = graph.import(state_);
  const gl::TextureDesc desc = graph.desc(hdr);
  const bool manual = settings.mode == static_cast<int>(ExposureMode::kManual);
  const auto towards = [&](double seconds) {
    return seconds > 0.0 ? static_cast<float>(1.0 - std::exp(-std::max(light.dt, 0.0) / seconds))
                         : 1.0f;
  };
  graph.add(
      "post.exposure",
      [&](PassBuilder& pass) {
        if (!manual) pass.read(hdr);
        pass.modify(state);
      },
      [this, hdr, desc, manual, light, settings,
       shares = glm::vec2(towards(settings.seconds / kFaster), towards(settings.seconds))](
          const PassContext& context) {
        if (manual) {
          const auto exposure = exposure_of_ev100(settings.ev100);
          const float values[3] = {static_cast<float>(std::log2(exposure)),
                                   static_cast<float>(exposure / light.exposure),
                                   static_cast<float>(std::log2(light.luminance))};
          state_.write(values, sizeof(values), offsetof(State, stops));
          return;
        }
        const auto exposure = static_cast<float>(light.exposure);
        glBindSampler(0, 0);
        context.texture(hdr).bind(0);
        state_.bind_storage(0);
        meter_.use();
        meter_.program().set(0, exposure);
        const auto groups = [](int pixels) { return static_cast<GLuint>((pixels + 63) / 64); };
        glDispatchCompute(groups(desc.width), groups(desc.height), 1);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        adapt_.use();
        const gl::Program& adapt = adapt_.program();
        adapt.set(0, exposure);
        adapt.set(1, static_cast<float>(std::log2(light.luminance * kPictureOverLight)));
        adapt.set(2, glm::vec4(static_cast<float>(settings.darkest),
                               static_cast<float>(settings.brightest),
                               static_cast<float>(settings.ev), kFollowed));
        adapt.set(3, shares);
        adapt.set(4, kCounted);
        glDispatchCompute(1, 1, 1);
      });
  return state;
}

Exposure::Reading Exposure::read() const {
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  State state{};
  state_.read(&state, sizeof(state));
  return {std::exp2(static_cast<double>(state.stops)),
          std::exp2(static_cast<double>(state.metered))};
}

double exposure_of_ev100(double ev100) { return 1.0 / (1.2 * std::exp2(ev100)); }

}  // namespace offing
