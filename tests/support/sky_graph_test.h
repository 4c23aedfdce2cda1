#pragma once
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <memory>

#include "engine/core/angles.h"
#include "engine/gl/buffer.h"
#include "engine/gl/texture.h"
#include "engine/sky/sky.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/frame.h"
#include "support/graph_test.h"

namespace offing::test {

/// A sun at this place, degrees, and a moon far down.
inline CelestialState sun_at(double azimuth_deg, double elevation_deg) {
  CelestialState s;
  s.sun.azimuth_deg = azimuth_deg;
  s.sun.elevation_deg = s.sun.elevation_airless_deg = elevation_deg;
  s.moon.elevation_deg = s.moon.elevation_airless_deg = -50.0;
  return s;
}

/// Toward an azimuth and an elevation, degrees.
inline glm::dvec3 toward(double azimuth_deg, double elevation_deg) {
  SkyPosition p;
  p.azimuth_deg = azimuth_deg;
  p.elevation_deg = elevation_deg;
  return p.direction();
}

/// A camera `eye` metres above the water, with a field of view (degrees) over its width; depth is
/// reversed and infinitely far.
inline shared::FrameData camera_toward(const glm::dvec3& forward, double fov_deg, int width,
                                       int height, double eye = 3.0) {
  const glm::vec3 up = std::abs(forward.y) > 0.99 ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
  const double half = std::tan(radians(fov_deg) / 2.0);
  glm::mat4 clip(0.0f);
  clip[0][0] = static_cast<float>(1.0 / half);
  clip[1][1] = static_cast<float>(width / (half * height));
  clip[2][3] = -1.0f;
  clip[3][2] = 0.1f;
  shared::FrameData frame{};
  frame.clip_from_relative = clip * glm::lookAt(glm::vec3(0.0f), glm::vec3(forward), up);
  frame.relative_from_clip = glm::inverse(frame.clip_from_relative);
  frame.viewport = {width, height, 1.0 / width, 1.0 / height};
  frame.camera = {0.0, eye, 0.0, 2.0 * half / width};
  return frame;
}

/// A test of what shows the sky: its tables, in quality low, and the frame block.
class SkyGraphTest : public GraphTest {
 protected:
  void SetUp() override {
    GraphTest::SetUp();
    if (IsSkipped()) return;
    sky_ = std::make_unique<Sky>(*shaders_, 0);
    frame_ = gl::Buffer("frame", sizeof(shared::FrameData));
  }

  void TearDown() override {
    sky_.reset();
    frame_ = {};
    hdr_ = {};
    depth_ = {};
    GraphTest::TearDown();
  }

  /// Begins a frame of this camera and light: binds the frame block, and adds the sky's tables to
  /// an empty graph.
  SkyIds begin_frame(shared::FrameData frame, const SkyLight& light) {
    light.fill(frame);
    frame_.write(frame);
    frame_.bind_uniform(OFFING_BIND_FRAME);
    graph_->begin_frame();
    return sky_->add_tables(*graph_, light);
  }

  /// The same in a breeze, where no picture is drawn.
  SkyIds begin_frame(const SkyLight& light) {
    shared::FrameData frame{};
    frame.camera = {0.0f, 3.0f, 0.0f, 1e-3f};
    frame.wind = {-6.0f, 0.0f, 5.0f, 8.0f};
    return begin_frame(frame, light);
  }

  /// Makes hdr_, in this format, and depth_.
  void make_picture(GLenum format, int width, int height) {
    hdr_ = gl::Texture("hdr", {.format = format, .width = width, .height = height});
    depth_ =
        gl::Texture("depth", {.format = GL_DEPTH_COMPONENT32F, .width = width, .height = height});
  }

  gl::Texture hdr_, depth_;
  std::unique_ptr<Sky> sky_;
  SkyLightModel model_;
  SkyLight light_;

 private:
  gl::Buffer frame_;
};

}  // namespace offing::test
