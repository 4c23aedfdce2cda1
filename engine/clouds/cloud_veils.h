#pragma once
#include "engine/clouds/cloud_field.h"
#include "engine/clouds/cloud_march.h"
#include "engine/clouds/cloud_shadow.h"
#include "engine/sky/sky.h"

namespace offing {

/// What of the clouds hangs in the air below them: shafts of light and shadow, and veils of rain.
/// Made at an eighth (low, medium) or a quarter of the picture's size and laid over everything that
/// is far off.
class CloudVeils {
 public:
  /// `quality` 0 (low) to 3 (ultra).
  CloudVeils(ShaderLibrary& shaders, int quality);

  /// Adds clouds.veils, clouds.veils_smooth and clouds.veils_draw; they run only where the view has
  /// clouds and wants shafts or rain. Under the clouds they belong over them, from above behind.
  void add(FrameGraph& graph, const CloudField& field, const CloudIds& ids, const Sky& sky,
           const SkyIds& sky_ids, const CloudShadow& shadow, const CloudShadowIds& shadow_ids,
           const CloudView& view, const CloudCamera& camera, TextureId hdr, TextureId depth,
           bool visible);

 private:
  void resize(glm::ivec2 size);

  int cell_;  ///< pixels of the picture to one of the veils, a side
  const ShaderProgram& program_;
  const ShaderProgram& smooth_program_;
  const ShaderProgram& draw_program_;
  gl::Sampler linear_;
  gl::VertexArray no_vertices_;
  gl::Texture rough_, smooth_;
  PassMemory memory_, smooth_memory_;
};

}  // namespace offing
