#pragma once
#include "engine/graph/frame_graph.h"
#include "engine/shader/shader_library.h"

namespace offing {

/// Makes slopes of the stairs at the outlines of things. T. Lottes: FXAA 3.11, NVIDIA 2011, but
/// only on solid things and where sea meets sky: glitter and clouds stay as sharp as they are.
class Antialias {
 public:
  explicit Antialias(ShaderLibrary& shaders);

  /// Changes `display`: what a display shows (RGBA8, sRGB). `solid`: depth of solid things alone,
  /// `depth`: of all, both of the same size and reversed (0 where there is nothing). At most a
  /// quarter of the pixels is changed.
  void add(FrameGraph& graph, TextureId solid, TextureId depth, TextureId display) const;

 private:
  const ShaderProgram& find_;
  const ShaderProgram& smooth_;
  const ShaderProgram& show_;
};

}  // namespace offing
