#include "game/world/camera.h"

#include <algorithm>
#include <cmath>

#include "engine/core/angles.h"

namespace offing {
namespace {

constexpr double kOffTheQuarter = -0.35;  // rad: the chase camera sees the sails, not their edges

// World from camera for a look along `heading` (from north, clockwise) and `pitch` (up positive).
glm::dquat level_look(double heading, double pitch) {
  return glm::angleAxis(-heading, glm::dvec3(0.0, 1.0, 0.0)) *
         glm::angleAxis(pitch, glm::dvec3(1.0, 0.0, 0.0));
}

double heading_of(const glm::dquat& orientation) {
  const glm::dvec3 bow = orientation * glm::dvec3(0.0, 0.0, -1.0);
  return std::atan2(bow.x, -bow.z);
}

glm::dquat look_at(glm::dvec3 from, glm::dvec3 to) {
  const glm::dvec3 way = to - from;
  const double flat = std::hypot(way.x, way.z);
  const double heading = flat > 1e-9 ? std::atan2(way.x, -way.z) : 0.0;
  return level_look(heading, std::atan2(way.y, flat));
}

}  // namespace

Camera::Camera(const CameraStart& start)
    : mode_(static_cast<CameraMode>(start.mode)),
      start_(start),
      field_of_view_(radians(start.field_of_view_deg)) {}

void Camera::set_mode(CameraMode mode) {
  mode_ = mode;
  yaw_ = pitch_ = 0.0;
  distance_ = 1.0;
  placed_ = false;
}

void Camera::next_mode() {
  // The free camera stays where a scene put it, so it is not among those to cycle through.
  switch (mode_) {
    case CameraMode::kChase:
      return set_mode(CameraMode::kHelm);
    case CameraMode::kHelm:
      return set_mode(CameraMode::kMast);
    case CameraMode::kMast:
      return set_mode(CameraMode::kOrbit);
    default:
      return set_mode(CameraMode::kChase);
  }
}

void Camera::look(double yaw, double pitch) {
  yaw_ = wrap_pi(yaw_ + yaw);
  pitch_ = std::clamp(pitch_ + pitch, -1.2, 1.2);
}

void Camera::zoom(double notches) {
  distance_ = std::clamp(distance_ * std::pow(0.88, notches), 0.35, 12.0);
}

void Camera::update(const CameraSubject& subject, double dt) {
  const double heading = heading_of(subject.orientation);
  if (!placed_) {
    followed_heading_ = heading;
    followed_height_ = subject.position.y;
    placed_ = true;
  }
  // Outside cameras follow with a lag, so that waves rock the boat and not the viewer.
  followed_heading_ += wrap_pi(heading - followed_heading_) * -std::expm1(-dt / 1.2);
  followed_height_ += (subject.position.y - followed_height_) * -std::expm1(-dt / 0.8);
  const double turned = yaw_ + (astern_ ? kPi : 0.0);

  switch (mode_) {
    case CameraMode::kChase:
    case CameraMode::kOrbit: {
      const bool orbit = mode_ == CameraMode::kOrbit;
      const double around = orbit ? 2.4 + turned : followed_heading_ + kOffTheQuarter + turned;
      const double down = std::clamp((orbit ? -0.22 : -0.20) + pitch_, -1.45, orbit ? 0.9 : 0.25);
      const double radius = (orbit ? 19.0 : 17.0) * distance_;
      const glm::dvec3 centre(subject.position.x, followed_height_ + 3.4, subject.position.z);
      const glm::dquat turn = level_look(around, down);
      pose_.position = centre - turn * glm::dvec3(0.0, 0.0, -radius);
      // Never under the crests between the eye and the boat; from all round one may dive.
      if (!orbit) pose_.position.y = std::max(pose_.position.y, followed_height_ + 1.2);
      pose_.orientation = look_at(pose_.position, centre);
      break;
    }
    case CameraMode::kHelm: {
      pose_.position = subject.position + subject.orientation * glm::dvec3(0.45, 2.05, 2.9);
      const glm::dquat level = level_look(heading + turned, pitch_ - 0.05);
      const glm::dquat aboard = subject.orientation *
                                glm::angleAxis(-turned, glm::dvec3(0.0, 1.0, 0.0)) *
                                glm::angleAxis(pitch_ - 0.05, glm::dvec3(1.0, 0.0, 0.0));
      pose_.orientation = glm::slerp(level, aboard, 0.35);
      break;
    }
    case CameraMode::kMast: {
      pose_.position = subject.position + subject.orientation * glm::dvec3(0.0, 11.6, 0.4);
      pose_.orientation = level_look(heading + turned, std::clamp(pitch_ - 0.45, -1.5, 1.5));
      break;
    }
    case CameraMode::kFree: {
      pose_.position = start_.position;
      const glm::dvec3 way = start_.target - start_.position;
      const double flat = std::hypot(way.x, way.z);
      const double towards = flat > 1e-9 ? std::atan2(way.x, -way.z) : 0.0;
      pose_.orientation =
          level_look(towards + turned, std::clamp(std::atan2(way.y, flat) + pitch_, -1.57, 1.57));
      break;
    }
  }
}

void Camera::keep_dry(double water_height) {
  constexpr double kOver = 0.6;  // m: more than the ripples that nobody has told of
  if (mode_ == CameraMode::kChase || mode_ == CameraMode::kHelm || mode_ == CameraMode::kMast) {
    pose_.position.y = std::max(pose_.position.y, water_height + kOver);
  }
}

glm::mat4 reversed_projection(double fov, double aspect, double near) {
  const double f = 1.0 / std::tan(0.5 * fov);
  glm::mat4 projection(0.0f);
  projection[0][0] = static_cast<float>(f / aspect);
  projection[1][1] = static_cast<float>(f);
  projection[2][3] = -1.0f;
  projection[3][2] = static_cast<float>(near);
  return projection;
}

}  // namespace offing
