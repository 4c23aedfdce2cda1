#pragma once
#include <glm/vec2.hpp>

#include <vector>

#include "engine/clouds/cloud_field.h"
#include "engine/clouds/cloud_shadow.h"
#include "engine/sky/sky.h"

namespace offing {

/// Clouds alone, as a camera sees them: four values a pixel, bottom row first.
struct CloudSightings {
  glm::ivec2 size{0};
  std::vector<glm::vec4> light;  ///< radiance (cd/m², with the air before the cloud), transmittance
  std::vector<float> distance;   ///< where the light comes from, in the mean (m); 0: no cloud
};

/// What the march and its references read.
struct CloudSources {
  const CloudField& field;
  CloudIds field_ids;
  const Sky& sky;
  SkyIds sky_ids;
  const CloudShadow& shadow;
  CloudShadowIds shadow_ids;
};

/// The slow, trusted ways of drawing the clouds. Both wait, and give the driver many small pieces
/// of work, so that no watchdog ends them. FrameData must be bound.
class CloudReference {
 public:
  explicit CloudReference(ShaderLibrary& shaders);

  /// 4096 even steps on every ray, the light marched to the end of the clouds at each (see
  /// clouds/reference.comp). `smoothed`: noise finer than a pixel is left out, as in the march.
  CloudSightings march(FrameGraph& graph, const CloudSources& sources, glm::ivec2 size,
                       bool smoothed = true) const;

  /// All orders of scattering by path tracing (see clouds/pathtrace.comp): the mean of `samples`
  /// paths a pixel, those that follow `first`: the same paths for the same numbers.
  CloudSightings path_trace(FrameGraph& graph, const CloudSources& sources, glm::ivec2 size,
                            int samples, int first = 0) const;

 private:
  const ShaderProgram& march_program_;
  const ShaderProgram& path_program_;
};

}  // namespace offing
