#pragma once
#include "engine/gl/texture.h"
#include "engine/graph/frame_graph.h"
#include "engine/shader/shader_library.h"

namespace offing {

/// The glow of bright things in an eye or a lens: part of all light, spread wide. A pyramid of the
/// picture from a quarter of its size down, and up again.
class Bloom {
 public:
  explicit Bloom(ShaderLibrary& shaders);

  /// Adds post.bloom; the result is a quarter of the size of `hdr` (radiance × exposure).
  TextureId add(FrameGraph& graph, TextureId hdr);

 private:
  const ShaderProgram& down_;
  const ShaderProgram& up_;
  gl::Sampler linear_;
};

/// Share of its light that an eye spreads, at an exposure (picture value of 1 cd/m^2): some percent
/// by day, where what is bright is little brighter than the rest; more by night, when its pupil is
/// wide and a lamp stands before black.
double glare_share(double exposure);

}  // namespace offing
