#pragma once
#include "engine/clouds/cloud_march.h"
#include "engine/clouds/cloud_reference.h"
#include "engine/graph/frame_graph.h"
#include "engine/graph/gl_device.h"
#include "engine/io/image.h"
#include "engine/shader/shader_library.h"
#include "game/frame/frame_view.h"
#include "game/world/scene.h"

namespace offing {

/// The low clouds of a view and nothing else, drawn in every way there is, on the current context.
class CloudRun {
 public:
  explicit CloudRun(const CloudQuality& quality);

  /// What one frame of the march costs: user time of the whole process on a software renderer, else
  /// the clock's (ms). Waits.
  double march(const FrameView& view);
  /// The picture after the last march().
  CloudSightings marched(const FrameView& view) const;

  CloudSightings reference(const FrameView& view, bool smoothed = true);
  CloudSightings path_trace(const FrameView& view, int samples, int first = 0);

  /// The sky behind the clouds without discs, cd/m², row 0 on top.
  Image sky(const FrameView& view);

  /// Runs `add` with everything that a pass of clouds may read brought up to date, and then the
  /// graph.
  struct Ids {
    SkyIds sky;
    CloudIds field;
    CloudShadowIds shadow;
  };
  void run(const FrameView& view, const std::function<void(FrameGraph&, const Ids&)>& add);
  void bind(const PassContext& context, const Ids& ids) const;

  ShaderLibrary& shaders() { return shaders_; }

 private:
  Ids prepare(const FrameView& view);
  CloudSources sources(const FrameView& view);

  ShaderLibrary shaders_;
  GlDevice device_;
  FrameGraph graph_;
  Sky sky_;
  CloudField field_;
  CloudShadow shadow_;
  CloudMarch march_;
  gl::Buffer frame_block_;
  const gl::Texture* seen_ = nullptr;
  bool software_;
};

/// What a scene's camera sees at its start, of a calm sea: for what does not show the boat.
FrameView still_view(Scene scene, glm::ivec2 size);

/// Clouds before a sky, row 0 on top, three channels in cd/m².
Image over_sky(const CloudSightings& clouds, const Image& sky);

/// The clock that costs are told by: see CloudRun::march(); ms.
double work_milliseconds(bool software);

}  // namespace offing
