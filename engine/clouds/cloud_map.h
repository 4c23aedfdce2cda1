#pragma once
#include <cstdint>
#include <optional>

#include "engine/clouds/cloud_field.h"
#include "engine/clouds/cloud_shadow.h"
#include "engine/sky/probe.h"
#include "engine/sky/sky.h"

namespace offing {

struct CloudMapSettings {
  int size = 64;   ///< texels a side
  int slices = 8;  ///< frames over which a refresh is spread
  int steps = 28;  ///< most of a ray, in and near cloud
  int light_steps = 2;

  /// 0 low to 3 ultra.
  static CloudMapSettings of_quality(int quality);
};

/// The clouds as seen from the boat, all round and up to the zenith: a hemi-octahedral map for the
/// reflection probe and for `export sky`. The eye is low over the water even where the camera is
/// among the clouds, since it is the sea's and the boat's clouds that are asked for.
///
/// While clouds or light move some rows are made in each frame, into a second map that takes the
/// first one's place when it is whole. Where nothing moves nothing is done.
class CloudMap {
 public:
  CloudMap(ShaderLibrary& shaders, const CloudMapSettings& settings);

  /// Adds clouds.map and returns what the probe takes in; nothing where there is no cloud.
  /// `data` is the block that field and shadow are read with in this frame.
  std::optional<ProbeClouds> add(FrameGraph& graph, const CloudField& field, const CloudIds& ids,
                                 const Sky& sky, const SkyIds& sky_ids, const CloudShadow& shadow,
                                 const CloudShadowIds& shadow_ids, const CloudView& view,
                                 const SkyLight& light, const shared::CloudData& data);

  const CloudMapSettings& settings() const { return settings_; }

 private:
  /// What a map was made for, coarse enough that one step of it cannot be seen.
  struct State {
    std::uint64_t weather = 0;  ///< all that makes other clouds at once
    std::uint64_t moment = 0;   ///< weather, time, place and light
    glm::dvec2 air{0.0};        ///< the eye in air that drifts with the clouds, m
    glm::dvec3 light{0.0, 1.0, 0.0};
  };
  /// The rows to make in this frame (first, number), and whether they are all of them.
  glm::ivec2 plan(const State& now);

  CloudMapSettings settings_;
  const ShaderProgram& program_;
  gl::Texture front_, back_;
  gl::Buffer block_;
  State shown_, coming_;
  glm::ivec2 rows_{0};
  bool known_ = false, working_ = false;
  std::uint64_t version_ = 0;
};

}  // namespace offing
