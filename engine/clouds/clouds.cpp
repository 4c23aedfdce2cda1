#include "engine/clouds/clouds.h"

namespace offing {

Cloudscape::Cloudscape(ShaderLibrary& shaders, int quality)
    : field_(shaders),
      shadow_(shaders),
      map_(shaders, CloudMapSettings::of_quality(quality)),
      march_(shaders, CloudQuality::of(quality)),
      veils_(shaders, quality) {}

CloudscapeIds Cloudscape::add_field(FrameGraph& graph, const CloudView& view,
                                    const SkyLight& light) {
  shared::CloudData data = cloud_data(view, light);
  shadow_.plan(view, data);
  CloudscapeIds ids;
  ids.field = field_.add(graph, view, data);
  ids.shadow = shadow_.add(graph, field_, ids.field, view);
  ids.data = data;
  return ids;
}

std::optional<ProbeClouds> Cloudscape::add_map(FrameGraph& graph, const CloudscapeIds& ids,
                                               const CloudView& view, const SkyLight& light,
                                               const Sky& sky, const SkyIds& sky_ids) {
  return map_.add(graph, field_, ids.field, sky, sky_ids, shadow_, ids.shadow, view, light,
                  ids.data);
}

void Cloudscape::add_picture(FrameGraph& graph, const CloudscapeIds& ids, const CloudView& view,
                             const CloudCamera& camera, const Sky& sky, const SkyIds& sky_ids,
                             TextureId hdr, TextureId depth, bool sky_visible, bool in_air) {
  const bool any = view.weather.cover > 0.0;
  const bool from_below = view.eye.y < field_.lowest_base();
  const bool visible = any && (sky_visible || !from_below);
  const TextureId seen = march_.add(graph, field_, ids.field, sky, sky_ids, shadow_, ids.shadow,
                                    view, camera, visible);
  const auto add_veils = [&] {
    veils_.add(graph, field_, ids.field, sky, sky_ids, shadow_, ids.shadow, view, camera, hdr,
               depth, in_air);
  };
  if (!from_below) add_veils();
  march_.add_composite(graph, field_, ids.field, sky, sky_ids, seen, hdr, depth, visible,
                       from_below);
  if (from_below) add_veils();
}

}  // namespace offing
