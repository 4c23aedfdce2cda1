#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstdint>

#include "engine/clouds/cloud_noise.h"
#include "engine/clouds/cloud_parameters.h"
#include "engine/clouds/weather_map.h"
#include "engine/environment/environment.h"
#include "engine/gl/buffer.h"
#include "engine/graph/frame_graph.h"
#include "engine/shader/shader_library.h"
#include "engine/sky/sky_light.h"
#include "shaders/shared/clouds.h"

namespace offing {

/// What clouds are drawn from: the weather of now, and from where they are seen.
struct CloudView {
  Clouds weather;                ///< cover, type, precipitation, high
  glm::dvec2 drift{0.0};         ///< Environment::air_drift()
  glm::dvec2 wind_to{0.0, 1.0};  ///< unit (x, z)
  double wind_speed = 8.0;       ///< m/s at 10 m
  double elapsed = 0.0;          ///< s
  glm::dvec3 eye{0.0};           ///< the camera in the world, m
  std::uint64_t seed = 1;
  CloudParameters parameters;
};

/// The clouds' field of density, in this frame's graph: what clouds/density.glsl reads.
struct CloudIds {
  TextureId shape, detail, curl, weather, most;
  BufferId block;  ///< shared::CloudData
  /// Declares that a pass uses density.glsl. Where it runs, CloudField::bind() must be called.
  void read_by(PassBuilder& pass) const;
};

/// Where there is cloud: noise, weather and the block that ties them to the camera.
class CloudField {
 public:
  explicit CloudField(ShaderLibrary& shaders);

  /// Adds clouds.noise, clouds.pack, clouds.weather and clouds.block: each runs only where somebody
  /// reads it and something has changed.
  CloudIds add(FrameGraph& graph, const CloudView& view, const shared::CloudData& data);

  /// Binds textures and block for density.glsl, within a pass that has declared ids.read_by().
  void bind(const PassContext& context, const CloudIds& ids) const;

  CloudNoise& noise() { return noise_; }
  /// Of what was added last, m over the sea.
  double lowest_base() const { return lowest_base_; }

 private:
  CloudNoise noise_;
  WeatherMap weather_;
  gl::Sampler volume_, plane_, nearest_;
  gl::Buffer block_;
  PassMemory block_memory_;
  double lowest_base_ = 0.0;
};

/// How far (x, z; m) and how fast (m/s) the wind at this height (m) carries clouds.
glm::dvec2 cloud_carried(const CloudView& view, double height);
glm::dvec2 cloud_velocity(const CloudView& view, double height);

/// Height of the bases in the mean, m over the sea.
double cloud_base(const CloudView& view);
/// Coordinates of the view's eye in the weather map, in periods.
glm::dvec2 weather_place(const CloudView& view);
/// How far rain from the bases lags behind its cloud at the sea, twice over (x, z; m): drops fall
/// into slower air, by the wind's difference at first and by nothing at the end.
glm::dvec2 rain_lag(const CloudView& view);

/// What density.glsl and the march read of a view and its light.
shared::CloudData cloud_data(const CloudView& view, const SkyLight& light);

}  // namespace offing
