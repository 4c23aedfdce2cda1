#include "engine/ocean/spray.h"

#include <algorithm>
#include <cmath>

namespace offing {
namespace {

constexpr int kGroup = 64;
constexpr double kLongestStep = 1.0;  // s; after longer ones it starts anew
constexpr std::size_t kDropBytes = 2 * 4 * sizeof(float);

}  // namespace

Spray::Spray(ShaderLibrary& shaders, int quality)
    : count_(quality <= 0   ? 4096
             : quality == 1 ? 8192
                            : 16384),
      step_(shaders.program({"ocean/spray.comp"})),
      picture_(shaders.program({"ocean/spray.vert", "ocean/spray.frag"})),
      drops_("sea.drops", kDropBytes * static_cast<std::size_t>(count_)),
      array_("sea.spray") {}

double Spray::amount(double wind_speed) {
  return std::clamp((wind_speed - 10.8) / (22.0 - 10.8), 0.0, 1.0);
}

void Spray::move(const SprayView& view) {
  const double seconds = view.time - time_;
  const glm::dvec2 moved = view.eye - eye_;
  if (flying_ && seconds == 0.0 && moved == glm::dvec2(0.0)) return;
  const bool anew = !flying_ || seconds < 0.0 || seconds > kLongestStep;
  step_.use();
  step_.program().set(
      0, glm::vec4(glm::dvec4(anew ? -1.0 : seconds, moved.x, moved.y, amount(view.wind_speed))));
  step_.program().set(1, number_++);
  drops_.bind_storage(0);
  glDispatchCompute(static_cast<GLuint>(count_ / kGroup), 1, 1);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  eye_ = view.eye;
  time_ = view.time;
  flying_ = true;
}

void Spray::add(FrameGraph& graph, const SprayView& view, const SurfaceAccess& surface,
                const LightAccess& sky, TextureId hdr, TextureId depth) {
  const bool none = !view.visible || amount(view.wind_speed) <= 0.0;
  if (none) flying_ = false;
  graph.add(
      "sea.spray",
      [&](PassBuilder& pass) {
        surface.declare(pass);
        sky.declare(pass);
        pass.read(depth, Access::kAttachment).modify(hdr).render_to({hdr}, depth);
        pass.skip_if(none);
      },
      [this, view, surface, sky](const PassContext& context) {
        surface.bind(context);
        sky.bind(context);
        move(view);
        picture_.use();
        drops_.bind_storage(0);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_GREATER);
        glDepthMask(GL_FALSE);
        glEnable(GL_BLEND);
        glBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
        array_.bind();
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count_);
        glDisable(GL_BLEND);
        glDisable(GL_DEPTH_TEST);
        glDepthMask(GL_TRUE);
        surface.unbind();
      });
}

}  // namespace offing
