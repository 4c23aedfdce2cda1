#pragma once
#include <cstdint>

#include "engine/gl/buffer.h"
#include "engine/gl/program.h"
#include "engine/graph/frame_graph.h"
#include "engine/shader/shader_library.h"

namespace offing {

enum class ToneCurve { kFilmic, kExponential };

struct TonemapSettings {
  ToneCurve curve = ToneCurve::kFilmic;
  /// What the HDR picture's radiance was multiplied by: tells day from night for the colours of
  /// dusk.
  double exposure = 1.0;
  bool count_nonfinite = false;
};

/// Turns the HDR picture (linear, radiance × exposure) into what a display shows (sRGB, dithered).
class Tonemap {
 public:
  explicit Tonemap(ShaderLibrary& shaders);

  /// `out`: an RGBA8 picture of the same size. NaN and infinite pixels become black.
  void add(FrameGraph& graph, TextureId hdr, TextureId out, const TonemapSettings& settings);

  /// Pixels that were NaN or infinite in frames that counted since the last call. Waits for the
  /// GPU.
  std::uint32_t take_nonfinite_pixels();

 private:
  const ShaderProgram& program(const TonemapSettings& settings) const;
  const ShaderProgram* programs_[2][2];  ///< [curve][counts]
  gl::VertexArray no_vertices_;
  gl::Buffer count_;
};

}  // namespace offing
