#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstdint>

#include "engine/clouds/cloud_noise.h"
#include "engine/clouds/cloud_view.h"
#include "engine/clouds/weather_map.h"
#include "engine/gl/buffer.h"
#include "engine/graph/frame_graph.h"
#include "engine/shader/shader_library.h"
#include "engine/sky/sky_light.h"
#include "shaders/shared/clouds.h"

namespace offing {

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
  double highest_top() const { return highest_top_; }
  /// Another number for every other field, place, moment or light of what was added last.
  std::uint64_t state() const { return state_; }

 private:
  CloudNoise noise_;
  WeatherMap weather_;
  gl::Sampler volume_, plane_, nearest_;
  gl::Buffer block_;
  PassMemory block_memory_;
  double lowest_base_ = 0.0, highest_top_ = 0.0;
  std::uint64_t state_ = 0;
};

/// What density.glsl and the march read of a view and its light.
shared::CloudData cloud_data(const CloudView& view, const SkyLight& light);

}  // namespace offing
