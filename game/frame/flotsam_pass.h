#pragma once
#include <array>
#include <vector>

#include "engine/gl/buffer.h"
#include "engine/graph/frame_graph.h"
#include "engine/io/model.h"
#include "engine/ocean/ocean.h"
#include "engine/shader/shader_library.h"
#include "game/frame/detail.h"
#include "game/frame/frame_view.h"
#include "shaders/shared/boat.h"

namespace offing {

/// Draws barrel, crate and raft with the boat's rigid surface. Skipped while none is in view.
class FlotsamPass {
 public:
  /// The model's nodes are those of kFlotsam, in their bodies' frames.
  FlotsamPass(ShaderLibrary& shaders, const Model& model);

  void add(FrameGraph& graph, const std::vector<FlotsamView>& things,
           const shared::FrameData& frame, const LightAccess& light, TextureId hdr,
           TextureId depth) const;

 private:
  const ShaderProgram& program_;
  std::array<DetailLevels, kFlotsam.size()> levels_;
  shared::BoatData block_{};
  gl::Buffer vertices_, indices_, buffer_;
  gl::VertexArray layout_;
};

}  // namespace offing
