#pragma once
#include "engine/gl/buffer.h"
#include "engine/graph/frame_graph.h"
#include "engine/post/exposure_settings.h"
#include "engine/shader/shader_library.h"

namespace offing {

/// What the picture's exposure is and what it is right for.
struct PictureLight {
  double exposure = 1.0;   ///< picture value of 1 cd/m^2
  double luminance = 1.0;  ///< cd/m^2 that an eye here is used to
  double dt = 0.0;         ///< s since the last frame
};

/// Histogram exposure: meters the picture on the GPU and adapts to it over seconds, within limits
/// about what the light of the place asks for. The first frame is adapted at once. Nothing is read
/// back.
class Exposure {
 public:
  explicit Exposure(ShaderLibrary& shaders);

  /// Adds post.exposure (skipped in manual mode). The buffer holds what Tonemap::add() wants.
  BufferId add(FrameGraph& graph, TextureId hdr, const PictureLight& light,
               const ExposureSettings& settings);

  /// The exposure adapted to (picture value of 1 cd/m^2) and the luminance metered (cd/m^2); waits.
  struct Reading {
    double exposure, luminance;
  };
  Reading read() const;

 private:
  const ShaderProgram& meter_;
  const ShaderProgram& adapt_;
  gl::Buffer state_;
};

/// Picture value of 1 cd/m^2 at an exposure value for ISO 100: 1 is where a camera's sensor is full
/// (ISO 2720; Lagarde & de Rousiers 2014, §4).
double exposure_of_ev100(double ev100);

}  // namespace offing
