#include "game/frame/cloth.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace offing {
namespace {

shared::ClothParameters common(const ClothStyle& style, double time, int node, float shaking) {
  double clock = time + style.time_offset;
  if (style.time_step > 0.0f) clock = std::floor(clock / style.time_step) * style.time_step;
  const float height = style.wave_height * std::lerp(style.wave_calm, 1.0f, shaking);
  shared::ClothParameters out;
  out.clock = {static_cast<float>(clock), 1.0f / style.wave_size, style.wave_speed, height};
  out.gradient_weight = {style.gradient_weight.x, style.gradient_weight.y, style.gradient_weight.z,
                         shaking};
  out.belly = {0.0f, 0.0f, style.belly_place, static_cast<float>(node)};
  out.attached = style.attached;
  out.stream = {0.0f, 0.0f, 1.0f, style.belly_at_foot};
  out.colour_a = {style.colour_a.x, style.colour_a.y, style.colour_a.z, style.through};
  out.colour_b = {style.colour_b.x, style.colour_b.y, style.colour_b.z, 0.0f};
  return out;
}

}  // namespace

ClothStyle mainsail_style() {
  ClothStyle style;
  style.wave_height = 0.55f;
  style.wave_calm = 0.02f;
  style.wave_speed = 5.0f;
  style.wave_size = 1.3f;
  style.attached = {1.0f, 0.0f, 0.9f, 0.5f};
  style.belly_depth = 0.105f;
  style.belly_at_foot = 0.35f;
  style.twist = 0.16f;
  return style;
}

ClothStyle jib_style() {
  ClothStyle style = mainsail_style();
  style.time_offset = 37.3f;
  style.attached = {1.0f, 0.0f, 0.6f, 0.2f};
  style.belly_depth = 0.125f;
  style.belly_place = 0.38f;
  style.belly_at_foot = 0.7f;
  style.twist = 0.20f;
  return style;
}

ClothStyle flag_style() {
  ClothStyle style;
  style.time_offset = 11.7f;
  style.wave_height = 0.20f;
  style.wave_calm = 0.35f;
  style.wave_speed = 2.4f;
  style.wave_size = 0.42f;
  style.gradient_weight = {1.0f, 0.15f, 0.15f};
  style.through = 0.35f;
  style.colour_a = {0.012f, 0.045f, 0.20f};
  style.colour_b = {0.85f, 0.72f, 0.25f};
  return style;
}

shared::ClothParameters sail_cloth(const ClothStyle& style, const SailView& sail, double time,
                                   int node) {
  shared::ClothParameters out = common(style, time, node, sail.luff);
  // Cloth does not stretch: a light air already fills most of the belly that a breeze does.
  const float full = sail.fill * 1.25f / (0.25f + std::abs(sail.fill));
  out.belly.x = style.belly_depth * full;
  out.belly.y = style.twist * full;
  return out;
}

FlagPose flag_pose(const glm::vec3& wind, const glm::vec3& down) {
  // Drag grows as the square of the speed, weight does not: at this speed they are equal.
  constexpr float kLiftingSpeed = 2.2f;
  constexpr float kSlackSpeed = 1.3f;  // a limp flag still stands off the staff by its folds
  constexpr float kFreshSpeed = 9.0f;
  FlagPose pose;
  const float speed = std::hypot(wind.x, wind.z);
  pose.yaw = speed > 0.0f ? std::atan2(wind.x, wind.z) : 0.0f;
  const float cosine = std::cos(pose.yaw), sine = std::sin(pose.yaw);
  const glm::vec3 down_turned(cosine * down.x - sine * down.z, down.y,
                              sine * down.x + cosine * down.z);
  const float drag = std::max(speed, kSlackSpeed) * std::max(speed, kSlackSpeed);
  pose.stream = glm::normalize(drag * glm::vec3(0.0f, 0.0f, 1.0f) +
                               kLiftingSpeed * kLiftingSpeed * down_turned);
  pose.strength = std::min(speed / kFreshSpeed, 1.0f);
  return pose;
}

shared::ClothParameters flag_cloth(const ClothStyle& style, const FlagPose& pose, double time,
                                   int node) {
  shared::ClothParameters out = common(style, time, node, pose.strength);
  out.stream = {pose.stream.x, pose.stream.y, pose.stream.z, style.belly_at_foot};
  return out;
}

}  // namespace offing
