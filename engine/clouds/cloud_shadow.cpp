#include "engine/clouds/cloud_shadow.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <utility>

#include "engine/core/random.h"
#include "shaders/shared/bindings.h"

namespace offing {
namespace {

constexpr double kFlattest = 0.05;  // sine of the light's elevation, at least: rays stay this short
constexpr double kMapStep = CloudShadow::kSide / 8.0;

gl::Texture cleared(const char* label) {
  gl::Texture texture(
      label, {.format = GL_RGBA16F, .width = CloudShadow::kTexels, .height = CloudShadow::kTexels});
  glClearTexImage(texture.id(), 0, GL_RGBA, GL_FLOAT, nullptr);
  return texture;
}

}  // namespace

void CloudShadowIds::read_by(PassBuilder& pass) const {
  pass.read(map).read(block, Access::kUniform);
}

CloudShadow::CloudShadow(ShaderLibrary& shaders)
    : program_(shaders.program({"clouds/shadow.comp"})),
      linear_("clouds shadow", GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE) {
  front_.texture = cleared("clouds shadow a");
  back_.texture = cleared("clouds shadow b");
}

void CloudShadow::plan(const CloudView& view, shared::CloudData& data) {
  const double height = data.layer.w;
  const glm::dvec2 eye = glm::dvec2(view.eye.x, view.eye.z) - cloud_carried(view, height);
  const glm::dvec2 middle = kMapStep * glm::round(eye / kMapStep);
  glm::dvec3 light(data.light_direction);
  light.y = std::max(light.y, kFlattest);
  light = glm::normalize(light);

  // What makes another field at once, and what only time does.
  const std::uint64_t field =
      hash_of(view.weather, data.form, data.layer, data.box.z, data.wind, data.light.x, view.seed,
              view.parameters.shape_weights, view.parameters.detail_weights,
              std::hash<std::string>()(view.parameters.weather_picture));
  const glm::dvec3 light_step = glm::round(light * 1000.0);
  const std::uint64_t moment = hash_of(field, light_step, middle, std::floor(view.elapsed / 2.0));

  if (working_ && rows_.x + rows_.y >= kTexels) {
    std::swap(front_, back_);
    working_ = false;
  }
  const bool jumped =
      glm::length(front_.middle - middle) > 0.3 * kSide || glm::dot(front_.light, light) < 0.999;
  into_front_ = !known_ || front_.field != field || jumped;
  Map* target = nullptr;
  if (into_front_) {
    target = &front_;
    rows_ = {0, kTexels};
    working_ = false;
  } else if (working_) {
    rows_.x += rows_.y;
    rows_.y = std::min(kRowsPerFrame, kTexels - rows_.x);
  } else if (front_.moment != moment) {
    target = &back_;
    rows_ = {0, kRowsPerFrame};
    working_ = true;
  } else {
    rows_ = {0, 0};
  }
  if (target != nullptr) {
    target->middle = middle;
    target->light = light;
    target->height = height;
    target->field = field;
    target->moment = moment;
  }
  known_ = true;
  const glm::dvec2 at = front_.middle - eye;
  data.shadow = glm::vec4(glm::dvec4(at, 1.0 / kSide, front_.height));
  data.shadow_light = glm::vec4(glm::vec3(front_.light), 0.0f);
}

CloudShadowIds CloudShadow::add(FrameGraph& graph, const CloudField& field, const CloudIds& ids,
                                const CloudView& view) {
  const CloudShadowIds shadow{graph.import(front_.texture), ids.block};
  Map& target = into_front_ ? front_ : back_;
  const TextureId written = graph.import(target.texture);
  const glm::dvec2 eye = glm::dvec2(view.eye.x, view.eye.z) - cloud_carried(view, target.height);
  const glm::vec2 middle(target.middle - eye);
  const glm::vec3 light(target.light);
  const glm::ivec2 rows = rows_;
  graph.add(
      "clouds.shadow",
      [&](PassBuilder& pass) {
        ids.read_by(pass);
        if (into_front_) {
          pass.write(written);
        } else {
          pass.modify(written, Access::kImage);
        }
        pass.side_effect();  // plan() counts on it, whoever reads it in this frame
        pass.skip_if(view.weather.cover <= 0.0 || rows.y == 0);
      },
      [this, &field, &target, ids, rows, middle, light](const PassContext& context) {
        field.bind(context, ids);
        program_.use();
        program_.program().set(0, rows);
        program_.program().set(1, middle);
        program_.program().set(2, light);
        target.texture.bind_image(0, GL_WRITE_ONLY);
        glDispatchCompute(kTexels / 8, static_cast<GLuint>((rows.y + 7) / 8), 1);
      });
  return shadow;
}

void CloudShadow::bind(const PassContext& context, const CloudShadowIds& ids) const {
  context.texture(ids.map).bind(OFFING_UNIT_CLOUD_SHADOW);
  linear_.bind(OFFING_UNIT_CLOUD_SHADOW);
  context.buffer(ids.block).bind_uniform(OFFING_BIND_CLOUDS);
}

}  // namespace offing
