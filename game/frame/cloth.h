#pragma once
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "game/frame/boat_view.h"
#include "shaders/shared/cloth.h"

namespace offing {

/// What a cloth is like: what does not change while it blows.
struct ClothStyle {
  float time_step = 0.0f;    ///< s; the cloth's clock ticks this often, 0: continuously
  float time_offset = 0.0f;  ///< s, so that two cloths do not move alike
  float wave_height = 0.1f;  ///< m, of a cloth that shakes with all its might
  float wave_calm = 0.0f;    ///< share of that height which is left in a cloth that stands well
  float wave_speed = 4.0f;   ///< m/s down the chord
  float wave_size = 1.0f;    ///< m, from crest to crest, about
  glm::vec3 gradient_weight{1.0f, 0.1f, 0.2f};  ///< how the noise moves it: across, up, along
  glm::vec4 attached{1.0f, 0.0f, 0.0f, 0.0f};   ///< luff, leech, foot, head: 0 free to 1 fixed
  float belly_depth = 0.0f;                     ///< over the chord
  float belly_place = 0.42f;                    ///< deepest point, share of the chord from the luff
  float belly_at_foot = 0.4f;                   ///< share of the depth left at the foot
  float twist = 0.0f;                           ///< rad, of the head against the foot, to leeward
  float through = 0.25f;                        ///< share of light that it lets through
  glm::vec3 colour_a{0.80f, 0.79f, 0.75f}, colour_b{0.02f, 0.035f, 0.10f};  ///< linear
};

ClothStyle mainsail_style();
ClothStyle jib_style();
ClothStyle flag_style();

/// The shader's parameters of a sail at `time` (s).
shared::ClothParameters sail_cloth(const ClothStyle& style, const SailView& sail, double time,
                                   int node);

/// How a flag on a vertical hoist flies.
struct FlagPose {
  float yaw;         ///< rad about the hoist from aft, positive to starboard: where the wind goes
  glm::vec3 stream;  ///< unit, in the flag's turned frame: aft in a breeze, drooping in a calm
  float strength;    ///< 0 calm to 1 fresh breeze
};
/// `wind` and `down` (unit) in the boat's frame.
FlagPose flag_pose(const glm::vec3& wind, const glm::vec3& down);

shared::ClothParameters flag_cloth(const ClothStyle& style, const FlagPose& pose, double time,
                                   int node);

}  // namespace offing
