#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace offing {

/// A sphere about all of her: masthead, bulb and boom end; boat frame, m.
inline constexpr glm::vec3 kBoatMiddle{0.0f, 4.9f, 0.0f};
inline constexpr float kBoatRadius = 7.8f;

/// How one sail stands now.
struct SailView {
  float angle = 0.0f;  ///< rad, of the chord (the boom) from the centreline, positive to starboard
  float fill =
      0.0f;  ///< -1 to 1: how hard the wind presses the belly and to which side, + starboard
  float luff = 0.0f;   ///< 0 full to 1 shaking
  float stall = 0.0f;  ///< 0 attached to 1 stalled
  float sheet = 0.0f;  ///< rad, the widest angle its sheet allows
};

/// All that drawing the boat needs to know of her: plain data, taken from the world once a frame.
struct BoatView {
  glm::vec3 position{
      0.0f};  ///< m: her origin (design waterline, amidships) less the camera's place
  glm::quat orientation{1.0f, 0.0f, 0.0f, 0.0f};  ///< world from boat (x starboard, y up, z aft)
  SailView main, jib;
  float rudder = 0.0f;             ///< rad, positive: trailing edge to starboard
  float reef = 1.0f;               ///< linear size of both sails, 0.4 to 1
  bool hoisted = true;             ///< whether the sails are up
  glm::vec3 apparent_wind{0.0f};   ///< m/s: velocity of the air past the boat, boat frame
  float navigation_lights = 0.0f;  ///< 0 off to 1 lit
};

}  // namespace offing
