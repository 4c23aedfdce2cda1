#pragma once
#include <cstdint>
#include <span>

#include "engine/gl/buffer.h"
#include "engine/gl/texture.h"
#include "engine/graph/frame_graph.h"
#include "engine/ocean/sea_transform.h"
#include "engine/ocean/spectrum.h"
#include "engine/shader/shader_library.h"

namespace offing {

/// How maps are kept: all in single precision, or slopes as half floats (66 dB instead of 120).
enum class MapStorage : std::uint8_t { kSingle, kHalfSlopes };

/// The sea's maps of this frame: arrays with one layer per cascade.
struct SeaIds {
  TextureId displacement;  ///< Dx, h, Dz, Dxz = dDx/dz; metres, float
  TextureId slopes;        ///< dh/dx, dh/dz, Dxx, Dzz
};

/// Makes the displacement and slope maps of a set of cascades for a moment: uploads the random
/// waves when they change, then two dispatches (columns, rows) that transform eight real fields of
/// every cascade, then coarser levels. The surface is analytic in time: any moment, in any order.
class SeaMaps {
 public:
  /// `size` is 64, 128, 256 or 512.
  SeaMaps(ShaderLibrary& shaders, int cascades, int size, MapStorage storage = MapStorage::kSingle);

  /// Takes other waves (as many cascades of the same size as at the start).
  void set_waves(std::span<const Cascade> cascades, double choppiness);

  /// Adds sea.spectrum, sea.fft and sea.maps for the sea's clock `time` (s). They run only when
  /// somebody reads the maps and the time or the waves have changed.
  SeaIds add(FrameGraph& graph, double time);

  int size() const { return size_; }
  int cascades() const { return cascades_; }
  const gl::Texture& displacement() const { return displacement_; }
  const gl::Texture& slopes() const { return slopes_; }

 private:
  int cascades_, size_;
  MapStorage storage_;
  const ShaderProgram& columns_;
  const ShaderProgram& rows_;
  const ShaderProgram& levels_;
  SeaModes packed_;
  unsigned waves_generation_ = 0;
  gl::Buffer twiddles_, modes_, grids_, work_, displacement_points_, slope_points_;
  gl::Texture displacement_, slopes_;
  PassMemory spectrum_memory_, fft_memory_, maps_memory_;
};

}  // namespace offing
