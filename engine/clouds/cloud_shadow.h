#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>

#include "engine/clouds/cloud_field.h"

namespace offing {

/// What clouds/shadow.glsl reads.
struct CloudShadowIds {
  TextureId map;
  BufferId block;
  /// Declares that a pass uses cloud_shadow(). Where it runs, CloudShadow::bind() must be called.
  void read_by(PassBuilder& pass) const;
};

/// The shadow of the clouds on sea, boat, air and other clouds: a Beer shadow map round the camera
/// that drifts with the air. Made anew some rows a frame, into a second map that takes the first
/// one's place when it is whole.
class CloudShadow {
 public:
  static constexpr double kSide = 26000.0;  ///< m
  static constexpr int kTexels = 128, kRowsPerFrame = 8;

  explicit CloudShadow(ShaderLibrary& shaders);

  /// Decides what is to be done in this frame and writes into `data` which map is read.
  void plan(const CloudView& view, shared::CloudData& data);
  /// Adds clouds.shadow, as planned. It does not run where there is no cloud.
  CloudShadowIds add(FrameGraph& graph, const CloudField& field, const CloudIds& ids,
                     const CloudView& view);
  void bind(const PassContext& context, const CloudShadowIds& ids) const;

 private:
  struct Map {
    gl::Texture texture;
    glm::dvec2 middle{0.0};  ///< x, z in air that drifts with the clouds, m
    glm::dvec3 light{0.0, 1.0, 0.0};
    double height = 0.0;       ///< m
    std::uint64_t field = 0;   ///< what it shows, without time
    std::uint64_t moment = 0;  ///< with time
  };
  const ShaderProgram& program_;
  gl::Sampler linear_;
  Map front_, back_;
  glm::ivec2 rows_{0};      ///< to be done in this frame: first and number
  bool into_front_ = true;  ///< all at once
  bool working_ = false;    ///< the back map is under way
  bool known_ = false;
  PassMemory memory_;
};

}  // namespace offing
