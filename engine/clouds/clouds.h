#pragma once
#include <optional>

#include "engine/clouds/cloud_field.h"
#include "engine/clouds/cloud_map.h"
#include "engine/clouds/cloud_march.h"
#include "engine/clouds/cloud_shadow.h"
#include "engine/clouds/cloud_veils.h"
#include "engine/sky/sky.h"

namespace offing {

/// The clouds of a frame, as ids.
struct CloudscapeIds {
  CloudIds field;
  CloudShadowIds shadow;
  shared::CloudData data{};  ///< what the field's block holds
};

/// All the clouds: what they are made of, the shadow they throw, and their picture.
class Cloudscape {
 public:
  /// `quality` 0 (low) to 3 (ultra).
  Cloudscape(ShaderLibrary& shaders, int quality);

  /// Brings field and shadow up to date, as far as anybody reads them.
  CloudscapeIds add_field(FrameGraph& graph, const CloudView& view, const SkyLight& light);
  /// The clouds as the probe takes them in; nothing where there are none.
  std::optional<ProbeClouds> add_map(FrameGraph& graph, const CloudscapeIds& ids,
                                     const CloudView& view, const SkyLight& light, const Sky& sky,
                                     const SkyIds& sky_ids);
  /// Draws the clouds over what stands in `hdr` behind them, the sky included, and what hangs in
  /// the air below them. `sky_visible`: whether the picture shows anything above the horizon.
  /// `in_air`: whether the eye is above the water.
  void add_picture(FrameGraph& graph, const CloudscapeIds& ids, const CloudView& view,
                   const CloudCamera& camera, const Sky& sky, const SkyIds& sky_ids, TextureId hdr,
                   TextureId depth, bool sky_visible, bool in_air = true);

  const CloudField& field() const { return field_; }
  CloudField& field() { return field_; }
  const CloudShadow& shadow() const { return shadow_; }
  const CloudMarch& march() const { return march_; }

 private:
  CloudField field_;
  CloudShadow shadow_;
  CloudMap map_;
  CloudMarch march_;
  CloudVeils veils_;
};

}  // namespace offing
