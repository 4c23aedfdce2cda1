#include "engine/clouds/cloud_veils.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "engine/clouds/lay_over.h"
#include "engine/core/random.h"
#include "shaders/shared/bindings.h"

namespace offing {
namespace {

constexpr int kShaftSteps = 12, kRainSteps = 16;
constexpr double kNearest = 200.0;  // m: what is nearer has no veil before it

GLuint groups(int size) { return static_cast<GLuint>((size + 7) / 8); }

}  // namespace

CloudVeils::CloudVeils(ShaderLibrary& shaders, int quality)
    : cell_(quality < 2 ? 8 : 4),
      program_(shaders.program({"clouds/veils.comp"})),
      smooth_program_(shaders.program({"clouds/veils_smooth.comp"})),
      draw_program_(shaders.program({"clouds/veils.vert", "clouds/veils.frag"})),
      linear_("clouds veils", GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE),
      no_vertices_("clouds veils without vertices") {}

void CloudVeils::resize(glm::ivec2 size) {
  const glm::ivec2 cells = (size + cell_ - 1) / cell_;
  if (rough_ && glm::ivec2(rough_.width(), rough_.height()) == cells) return;
  const gl::TextureDesc desc{.format = GL_RGBA16F, .width = cells.x, .height = cells.y};
  rough_ = gl::Texture("clouds veils rough", desc);
  smooth_ = gl::Texture("clouds veils", desc);
  memory_.reset();
  smooth_memory_.reset();
}

void CloudVeils::add(FrameGraph& graph, const CloudField& field, const CloudIds& ids,
                     const Sky& sky, const SkyIds& sky_ids, const CloudShadow& shadow,
                     const CloudShadowIds& shadow_ids, const CloudView& view,
                     const CloudCamera& camera, TextureId hdr, TextureId depth, bool visible) {
  resize(camera.size);
  const CloudEffects& effects = view.parameters.effects;
  const bool raining = view.weather.precipitation > 0.0 && effects.rain_rate > 0.0;
  const int shaft_steps = effects.shafts > 0.0 ? kShaftSteps : 0;
  const int rain_steps = raining ? kRainSteps : 0;
  const bool wanted = visible && view.weather.cover > 0.0 && shaft_steps + rain_steps > 0;
  const glm::dvec2 lag = rain_lag(view);
  const glm::vec4 amount(effects.shafts, effects.rain_rate, lag.x, lag.y);
  const std::uint64_t key =
      hash_of(camera.clip_from_relative, camera.eye, camera.exposure, view.elapsed, view.drift,
              amount, rain_steps, shaft_steps, view.weather, program_.generation());
  const TextureId rough = graph.import(rough_), smooth = graph.import(smooth_);
  graph.add(
      "clouds.veils",
      [&](PassBuilder& pass) {
        ids.read_by(pass);
        sky_ids.read_by(pass);
        shadow_ids.read_by(pass);
        pass.write(rough).cache(memory_, key).skip_if(!wanted);
      },
      [this, &field, &sky, &shadow, ids, sky_ids, shadow_ids, amount, shaft_steps,
       rain_steps](const PassContext& context) {
        sky.bind(context, sky_ids);
        field.bind(context, ids);
        shadow.bind(context, shadow_ids);
        program_.use();
        program_.program().set(0, cell_);
        program_.program().set(1, amount);
        program_.program().set(2, glm::ivec2(shaft_steps, rain_steps));
        rough_.bind_image(0, GL_WRITE_ONLY);
        glDispatchCompute(groups(rough_.width()), groups(rough_.height()), 1);
      });
  graph.add(
      "clouds.veils_smooth",
      [&](PassBuilder& pass) {
        pass.read(rough).write(smooth);
        pass.cache(smooth_memory_, smooth_program_.generation()).skip_if(!wanted);
      },
      [this](PassContext&) {
        smooth_program_.use();
        rough_.bind(0);
        smooth_.bind_image(0, GL_WRITE_ONLY);
        glDispatchCompute(groups(smooth_.width()), groups(smooth_.height()), 1);
      });
  // With reversed depth a thing at distance d has the near side over d.
  const float far_enough = camera.clip_from_relative[3][2] / static_cast<float>(kNearest);
  graph.add(
      "clouds.veils_draw",
      [&](PassBuilder& pass) {
        pass.read(smooth).modify(hdr).read(depth, Access::kAttachment).render_to({hdr}, depth);
        pass.skip_if(!wanted);
      },
      [this, far_enough](PassContext&) {
        const LayOver over;
        smooth_.bind(0);
        linear_.bind(0);
        no_vertices_.bind();
        draw_program_.use();
        draw_program_.program().set(0, far_enough);
        glDrawArrays(GL_TRIANGLES, 0, 3);
      });
}

}  // namespace offing
