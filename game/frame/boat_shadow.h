#pragma once
#include "engine/gl/buffer.h"
#include "engine/gl/texture.h"
#include "engine/graph/frame_graph.h"
#include "game/frame/boat_pass.h"
#include "shaders/shared/boat_shadow.h"

namespace offing {

/// How the boat's shadow map is laid over a sphere about all of her: across the brighter light, one
/// side along her keel, so that it turns with her. `side`: texels of one half of the map; `taps`, 1
/// or 4: how often a shader reads it for one place.
shared::BoatShadowData boat_shadow_data(const BoatView& view, const shared::FrameData& frame,
                                        int side, int taps);

/// The boat's shadow on herself, on the sea and on what floats near her: the depth of her opaque
/// parts and that of her sails, as the sun or the moon sees them, side by side. Sails let a share
/// of the light through.
class BoatShadow {
 public:
  /// Of a quality level, 0 to 3.
  explicit BoatShadow(int quality);

  /// Adds boat.shadow; it is skipped where no light casts one, or where it cannot be in sight.
  void add(FrameGraph& graph, const BoatPass& boat, const BoatView& view,
           const shared::FrameData& frame);
  /// Declares that a pass uses boat/shadow.glsl; bind() must be called where it runs.
  void read_by(PassBuilder& pass) const { pass.read(id_); }
  void bind() const;
  /// Depth, 0 at the light's side: the opaque parts' on the left, the sails' on the right.
  const gl::Texture& map() const { return map_; }

 private:
  int side_, taps_;
  gl::Texture map_;
  gl::Sampler compare_;
  gl::Buffer block_;
  TextureId id_;
};

}  // namespace offing
