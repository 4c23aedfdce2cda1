#include "game/frame/boat_shadow.h"

#include <epoxy/gl.h>

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "shaders/shared/bindings.h"

namespace offing {
namespace {

// Of half the map's side, so that its rim stays empty.
constexpr float kUsed = 0.95f;

// 0 the sun, 1 the moon, -1 neither: the brighter of those that are up.
int casting_light(const shared::FrameData& frame) {
  const float sun = frame.sun_illuminance.y, moon = frame.moon_illuminance.y;
  if (std::max(sun, moon) <= 0.0f) return -1;
  return sun >= moon ? 0 : 1;
}

}  // namespace

shared::BoatShadowData boat_shadow_data(const BoatView& view, const shared::FrameData& frame,
                                        int side, int taps) {
  shared::BoatShadowData data{};
  const int light = casting_light(frame);
  const glm::vec3 toward(light == 1 ? frame.moon_direction : frame.sun_direction);
  const glm::vec3 keel = view.orientation * glm::vec3(0.0f, 0.0f, 1.0f);
  const glm::vec3 mast = view.orientation * glm::vec3(0.0f, 1.0f, 0.0f);
  // Whichever of the two lies more across the light.
  const glm::vec3 along =
      std::abs(glm::dot(keel, toward)) < std::abs(glm::dot(mast, toward)) ? keel : mast;
  const glm::vec3 right = glm::normalize(along - glm::dot(along, toward) * toward);
  const glm::vec3 up = glm::cross(toward, right);
  const glm::vec3 middle = view.position + view.orientation * kBoatMiddle;
  const float half = kBoatRadius / kUsed;
  glm::mat4& map = data.map_from_relative;
  map = glm::mat4(1.0f);
  for (int axis = 0; axis < 3; ++axis) {
    map[axis] = glm::vec4(0.5f * right[axis] / half, 0.5f * up[axis] / half,
                          -0.5f * toward[axis] / kBoatRadius, 0.0f);
  }
  map[3] = glm::vec4(glm::vec3(0.5f) - glm::mat3(map) * middle, 1.0f);
  data.light = glm::vec4(toward, static_cast<float>(light));
  data.map = {static_cast<float>(taps), 1.0f / static_cast<float>(side), 0.5f / kBoatRadius,
              mainsail_style().through};
  return data;
}

BoatShadow::BoatShadow(int quality)
    : side_(quality <= 1 ? 512 : 1024),
      taps_(quality <= 0 ? 1 : 4),
      map_("boat.shadow", {.format = GL_DEPTH_COMPONENT16, .width = 2 * side_, .height = side_}),
      compare_("boat.shadow", GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE),
      block_("boat.shadow_block", sizeof(shared::BoatShadowData)) {
  glSamplerParameteri(compare_.id(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glSamplerParameteri(compare_.id(), GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
}

void BoatShadow::add(FrameGraph& graph, const BoatPass& boat, const BoatView& view,
                     const shared::FrameData& frame) {
  shared::BoatShadowData data = boat_shadow_data(view, frame, side_, taps_);
  // Where the light ends that passes her: as far down as the sea, longer than that only in sunsets.
  const float low = std::max(data.light.y, 0.15f);
  const glm::vec3 middle = view.position + view.orientation * kBoatMiddle;
  const float reach = kBoatRadius / low;
  const bool seen =
      sphere_in_view(frame.clip_from_relative, middle - 0.5f * reach * glm::vec3(data.light),
                     kBoatRadius + 0.5f * reach);
  if (!seen) data.light.w = -1.0f;
  block_.write(data);
  id_ = graph.import(map_);
  graph.add(
      "boat.shadow",
      [&](PassBuilder& pass) {
        pass.write(id_, Access::kAttachment).render_to({}, id_).skip_if(data.light.w < 0.0f);
      },
      [this, &boat, pose = boat.pose(view, frame)](PassContext&) {
        const float far = 1.0f;
        glDepthMask(GL_TRUE);
        glClearBufferfv(GL_DEPTH, 0, &far);
        block_.bind_uniform(OFFING_BIND_BOAT_SHADOW);
        glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LESS);
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(1.5f, 2.0f);
        glViewport(0, 0, side_, side_);
        boat.cast_opaque(pose);
        glViewport(side_, 0, side_, side_);
        boat.cast_cloth(pose);
        glDisable(GL_POLYGON_OFFSET_FILL);
        glDisable(GL_DEPTH_TEST);
      });
}

void BoatShadow::bind() const {
  block_.bind_uniform(OFFING_BIND_BOAT_SHADOW);
  map_.bind(OFFING_UNIT_BOAT_SHADOW);
  compare_.bind(OFFING_UNIT_BOAT_SHADOW);
}

}  // namespace offing
