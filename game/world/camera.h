#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "game/world/scene.h"

namespace offing {

/// What the camera follows: the boat's origin at the waterline and its attitude.
struct CameraSubject {
  glm::dvec3 position{0.0};
  glm::dquat orientation{1.0, 0.0, 0.0, 0.0};  ///< world from boat (x starboard, y up, z aft)
};

/// An eye and where it looks. Double precision: only differences from it ever reach the GPU.
struct CameraPose {
  glm::dvec3 position{0.0};
  glm::dquat orientation{1.0, 0.0, 0.0, 0.0};  ///< world from camera, looking along -z, y up
};

/// The five cameras. The outside ones keep a level horizon; the ones on board move with the boat,
/// with part of her roll, as a head does.
class Camera {
 public:
  explicit Camera(const CameraStart& start);

  CameraMode mode() const { return mode_; }
  void set_mode(CameraMode mode);
  void next_mode();
  /// Turns the look by these angles (rad): right and up are positive.
  void look(double yaw, double pitch);
  /// Nearer (> 0) or farther (< 0), in notches of the wheel.
  void zoom(double notches);
  /// Looks astern for as long as it is asked to.
  void set_look_astern(bool astern) { astern_ = astern; }

  /// Follows the subject; `dt` smooths the chase camera. The first call jumps there.
  void update(const CameraSubject& subject, double dt);
  /// Cameras that follow her from astern or stand on deck stay over the water, whose height at the
  /// camera this is (m). The others may dive.
  void keep_dry(double water_height);
  const CameraPose& pose() const { return pose_; }
  double field_of_view() const { return field_of_view_; }  ///< rad, vertical

 private:
  CameraMode mode_;
  CameraStart start_;
  double field_of_view_;
  double yaw_ = 0.0, pitch_ = 0.0, distance_ = 1.0;
  bool astern_ = false;
  bool placed_ = false;
  double followed_heading_ = 0.0;
  double followed_height_ = 0.0;
  CameraPose pose_;
};

/// Reversed-depth projection without a far plane: 1 at `near`, 0 infinitely far. `fov` vertical,
/// rad.
glm::mat4 reversed_projection(double fov, double aspect, double near);

}  // namespace offing
