#pragma once
#include <glm/vec2.hpp>

#include <cstdint>

#include "engine/gl/buffer.h"
#include "engine/gl/program.h"
#include "engine/graph/frame_graph.h"
#include "engine/ocean/underwater.h"
#include "engine/shader/shader_library.h"

namespace offing {

/// From where and when spray is looked at.
struct SprayView {
  glm::dvec2 eye{0.0};      ///< x, z of the camera in the world, m
  double time = 0.0;        ///< the sea's clock, s
  double wind_speed = 0.0;  ///< at 10 m, m/s
  bool visible = true;
};

/// Spray that the wind tears off breaking crests: some thousands of soft clouds of drops within 180
/// m of the viewer, born where the summed surface folds, carried along by the wind. Little of it
/// from force 6 on, spindrift from force 8 on.
class Spray {
 public:
  /// `quality`: 0 low to 3 ultra.
  Spray(ShaderLibrary& shaders, int quality);

  /// Adds sea.spray, which moves it and draws it over `hdr` behind what is nearer in `depth`.
  /// Skipped where the wind tears nothing off. A clock that stands still moves nothing; one that
  /// jumps starts anew.
  void add(FrameGraph& graph, const SprayView& view, const SurfaceAccess& surface,
           const LightAccess& sky, TextureId hdr, TextureId depth);

  /// How much there is: 0 below 10.8 m/s (force 6), 1 from 22 m/s on.
  static double amount(double wind_speed);
  int count() const { return count_; }
  const gl::Buffer& drops() const { return drops_; }

 private:
  void move(const SprayView& view);

  int count_;
  const ShaderProgram& step_;
  const ShaderProgram& picture_;
  gl::Buffer drops_;
  gl::VertexArray array_;
  glm::dvec2 eye_{0.0};
  double time_ = 0.0;
  bool flying_ = false;
  std::uint32_t number_ = 0;
};

}  // namespace offing
