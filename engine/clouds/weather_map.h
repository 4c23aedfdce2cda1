#pragma once
#include <filesystem>
#include <string>

#include "engine/clouds/cloud_parameters.h"
#include "engine/clouds/weather_noise.h"
#include "engine/environment/environment.h"
#include "engine/gl/texture.h"
#include "engine/graph/frame_graph.h"
#include "engine/shader/shader_library.h"

namespace offing {

/// The thickness of the tallest cloud that a weather can hold, m, at the clouds' usual scale.
double tallest_cloud(const Clouds& weather);
/// The same of its storms; 0: none.
double tallest_storm(const Clouds& weather);

/// Which clouds stand where: a tileable map of coverage, type, height of the bases and rain.
/// Carried by the wind as a whole (CloudData::weather) while its parts come and go.
class WeatherMap {
 public:
  static constexpr double kPeriod = kWeatherPeriod;  ///< m
  static constexpr int kTexels = 256, kCells = 128;

  explicit WeatherMap(ShaderLibrary& shaders);

  struct Ids {
    TextureId weather;  ///< RGBA8: coverage (evenly distributed), type, base, rain
    TextureId most;     ///< R8: see clouds/most.comp
  };
  /// Adds clouds.weather, which runs when the weather has changed, and at most every kStep seconds
  /// of the clock. Throws InputError where a picture is asked for that cannot be read.
  Ids add(FrameGraph& graph, TextureId patterns, const Clouds& weather, double elapsed,
          const CloudParameters& parameters, std::uint64_t seed);

  /// Time between two states of the map, s: in it an edge moves less than two metres.
  static constexpr double kStep = 1.0;

 private:
  void load_picture(const std::string& file);

  const ShaderProgram& weather_program_;
  const ShaderProgram& most_program_;
  gl::Texture weather_, most_, picture_;
  gl::Sampler repeating_;
  std::string picture_file_;
  glm::vec4 picture_channels_{0.0f};
  PassMemory memory_;
};

}  // namespace offing
