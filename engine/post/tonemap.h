#pragma once
#include <cstdint>

#include "engine/gl/buffer.h"
#include "engine/gl/program.h"
#include "engine/graph/frame_graph.h"
#include "engine/shader/shader_library.h"

namespace offing {

enum class ToneCurve { kFilmic, kExponential };

/// Up to this exposure what rods add is less than half a step of an 8-bit display, even where the
/// picture is shown four times as bright: night sight is left out.
inline constexpr double kFirstNight = 1.2e-4;

struct TonemapSettings {
  ToneCurve curve = ToneCurve::kFilmic;
  /// What the HDR picture's radiance was multiplied by: tells day from night for the colours of
  /// dusk.
  double exposure = 1.0;
  /// Of the light that is taken from the glow instead of the picture.
  double glow_share = 0.0;
};

/// Turns the HDR picture (linear, radiance × exposure) into what a display shows (sRGB, dithered).
class Tonemap {
 public:
  explicit Tonemap(ShaderLibrary& shaders);

  /// `out`: an RGBA8 picture of the same size. NaN and infinite pixels become black, and are
  /// counted. `exposure`: of Exposure::add(); without one the picture's own exposure is shown.
  /// `glow`: of Bloom::add().
  void add(FrameGraph& graph, TextureId hdr, TextureId out, const TonemapSettings& settings,
           BufferId exposure = {}, TextureId glow = {});

  /// Pixels that were NaN or infinite since the last call. Waits for the GPU.
  std::uint32_t take_nonfinite_pixels();

 private:
  const ShaderProgram& program(const TonemapSettings& settings) const;
  const ShaderProgram* programs_[2][2];  ///< [curve][night]
  gl::VertexArray no_vertices_;
  gl::Buffer count_;
  gl::Buffer unexposed_;  ///< stands for the state of Exposure: factor 1
  gl::Texture no_glow_;
  gl::Sampler linear_;
};

}  // namespace offing
