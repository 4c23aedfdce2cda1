#pragma once
#include <filesystem>
#include <string>

#include "engine/clouds/cloud_parameters.h"
#include "engine/gl/texture.h"
#include "engine/graph/frame_graph.h"
#include "engine/shader/shader_library.h"

namespace offing {

/// The noise that clouds are made of: two tileable volumes, a plane of curl and a plane of weather.
/// Made on the GPU at first use, kept in a file between runs.
class CloudNoise {
 public:
  static constexpr int kShapeTexels = 128;    ///< a side
  static constexpr int kDetailTexels = 32;    ///< a side
  static constexpr int kCurlTexels = 128;     ///< a side
  static constexpr int kWeatherTexels = 256;  ///< a side

  explicit CloudNoise(ShaderLibrary& shaders);

  struct Ids {
    TextureId shape, detail;  ///< R8, repeating, with mips: 0 … 1
    TextureId curl;           ///< RG8_SNORM
    TextureId weather;        ///< RGBA8, each channel evenly distributed over 0 … 1
  };
  /// Adds clouds.noise, which runs once, and clouds.pack, which runs when weights have changed.
  Ids add(FrameGraph& graph, const CloudParameters& parameters);

  /// Where the noise is kept; nowhere if empty. By default in cache_folder().
  void set_cache_file(std::filesystem::path file) { cache_file_ = std::move(file); }

 private:
  void make_or_load();
  void generate() const;
  std::string contents() const;

  const ShaderProgram& noise_program_;
  const ShaderProgram& curl_program_;
  const ShaderProgram& pack_program_;
  std::filesystem::path cache_file_;
  gl::Texture shape_channels_, detail_channels_, shape_, detail_, curl_, weather_;
  PassMemory noise_memory_, pack_memory_;
};

}  // namespace offing
