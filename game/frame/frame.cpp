#include "game/frame/frame.h"

#include <algorithm>
#include <array>
#include <optional>

#include "engine/core/paths.h"
#include "engine/io/model.h"
#include "shaders/shared/bindings.h"

namespace offing {
namespace {

// Uploads what every pass may read, and empties the picture.
void add_begin(FrameGraph& graph, const FrameView& view, const gl::Buffer& frame_block,
               TextureId hdr, TextureId depth) {
  const BufferId block = graph.import(frame_block);
  graph.add(
      "frame.begin",
      [&](PassBuilder& pass) {
        pass.write(block, Access::kTransfer)
            .write(hdr, Access::kAttachment)
            .write(depth, Access::kAttachment);
        pass.render_to({hdr}, depth);
      },
      [&view, &frame_block](PassContext&) {
        frame_block.write(view.frame);
        frame_block.bind_uniform(OFFING_BIND_FRAME);
        glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
        glDepthMask(GL_TRUE);
        const float black[4] = {0.0f, 0.0f, 0.0f, 0.0f}, far = 0.0f;
        glClearBufferfv(GL_COLOR, 0, black);
        glClearBufferfv(GL_DEPTH, 0, &far);
      });
}

/// Adds frame.solid: the depth of what is drawn so far, before the sea covers it.
TextureId add_solid(FrameGraph& graph, TextureId depth, bool needed) {
  const TextureId solid = graph.create("solid", graph.desc(depth));
  graph.add(
      "frame.solid",
      [&](PassBuilder& pass) {
        pass.read(depth, Access::kTransfer).write(solid, Access::kTransfer).skip_if(!needed);
      },
      [depth, solid](const PassContext& context) {
        const gl::Texture& from = context.texture(depth);
        glCopyImageSubData(from.id(), GL_TEXTURE_2D, 0, 0, 0, 0, context.texture(solid).id(),
                           GL_TEXTURE_2D, 0, 0, 0, 0, from.width(), from.height(), 1);
      });
  return solid;
}

Lens lens(const FrameView& view, const Ocean& ocean) {
  std::array<glm::vec3, 4> near;
  for (std::size_t i = 0; i < near.size(); ++i) {
    const glm::vec4 corner = view.frame.relative_from_clip *
                             glm::vec4(i % 2 == 0 ? -1.0f : 1.0f, i < 2 ? -1.0f : 1.0f, 1.0f, 1.0f);
    near[i] = glm::vec3(corner) / corner.w;
  }
  return ocean.lens(view.camera, near, view.sea_time);
}

OceanView ocean_view(const FrameView& view, const Techniques& t, Lens lens) {
  OceanView sea;
  sea.clip_from_relative = view.frame.clip_from_relative;
  sea.eye = {view.camera.x, view.camera.z};
  sea.eye_height = view.camera.y;
  sea.time = view.sea_time;
  sea.hull_in_view = t.boat.in_view(view.boat, view.frame);
  sea.clouds = view.clouds.weather.cover > 0.0;
  sea.gusts = view.frame.wind.y;
  sea.gust_origin = view.gust_origin;
  sea.squalls = view.squalls;
  sea.squall_corner = view.squall_corner;
  sea.chlorophyll = view.chlorophyll;
  sea.lens = lens;
  return sea;
}

// What of the light is ready when the sea and the boat are drawn.
struct LightIds {
  SkyIds sky;
  ProbeIds probe;
  CloudShadowIds shadow;
};

LightAccess light_access(const Techniques& t, const LightIds& ids) {
  return {[&t, ids](PassBuilder& pass) {
            ids.sky.read_by(pass);
            ids.probe.read_by(pass);
            ids.shadow.read_by(pass);
            t.boat_shadow.read_by(pass);
          },
          [&t, ids](const PassContext& context) {
            t.sky.bind(context, ids.sky);
            t.probe.bind(context, ids.probe);
            t.clouds.shadow().bind(context, ids.shadow);
            t.boat_shadow.bind();
          }};
}

CloudCamera cloud_camera(const FrameView& view) {
  return {view.size, view.frame.clip_from_relative, view.camera, view.light.exposure};
}

}  // namespace

Techniques::Techniques(ShaderLibrary& shaders, const Quality& quality,
                       const std::filesystem::path& boat_model)
    : sky(shaders, quality.level),
      probe(shaders, ProbeSettings::of_quality(quality.level)),
      clouds(shaders, quality.level),
      ocean(shaders, OceanSettings::of_quality(quality.level)),
      gardner(shaders),
      boat(shaders,
           load_model(boat_model.empty() ? data_root() / "assets/models/r8/r8.glb" : boat_model,
                      kBoatNodeNames),
           load_boat_textures(data_root() / "assets/textures")),
      boat_shadow(quality.level),
      flotsam(shaders, load_model(data_root() / "assets/models/flotsam/flotsam.glb", kFlotsam)),
      exposure(shaders),
      bloom(shaders),
      tonemap(shaders),
      frame_block("frame", sizeof(shared::FrameData)) {
  if (quality.level > 0) antialias.emplace(shaders);
}

FramePictures::FramePictures(glm::ivec2 size)
    : hdr("hdr", {.format = GL_RGBA16F, .width = size.x, .height = size.y}),
      depth("depth", {.format = GL_DEPTH_COMPONENT32F, .width = size.x, .height = size.y}),
      display("display", {.format = GL_RGBA8, .width = size.x, .height = size.y}) {}

TextureId build_frame(FrameGraph& graph, const FrameView& view, Techniques& t,
                      const FramePictures& pictures) {
  const TextureId hdr = graph.import(pictures.hdr);
  const TextureId depth = graph.import(pictures.depth);
  const TextureId display = graph.import(pictures.display);

  const Lens wet = t.boat.holds_eye(view.boat) ? Lens::kDry : lens(view, t.ocean);
  const bool sky_visible = view.sky_visible && wet != Lens::kSubmerged;
  GardnerView gardner = view.gardner;
  gardner.sky_visible = sky_visible;
  gardner.size = view.size;

  add_begin(graph, view, t.frame_block, hdr, depth);
  const SkyIds sky = t.sky.add_tables(graph, view.light);
  const CloudscapeIds clouds = t.clouds.add_field(graph, view.clouds, view.light);
  const std::optional<ProbeClouds> cloud_map =
      t.clouds.add_map(graph, clouds, view.clouds, view.light, t.sky, sky);
  const ProbeIds probe =
      t.probe.add(graph, view.light, view.frame.wind.w, t.sky, sky, cloud_map, view.probe);
  t.boat_shadow.add(graph, t.boat, view.boat, view.frame);
  const LightAccess light = light_access(t, {sky, probe, clouds.shadow});
  const SeaIds sea = t.ocean.add_maps(graph, view.sea_time);
  const TextureId hull = t.boat.add_mask(graph, view.boat, view.frame);
  t.boat.add(graph, view.boat, view.frame, light, hdr, depth);
  t.flotsam.add(graph, view.flotsam, view.frame, light, hdr, depth);
  const TextureId solid = add_solid(graph, depth, wet != Lens::kDry || t.antialias);
  const OceanView at_sea = ocean_view(view, t, wet);
  const UnderwaterIds under =
      t.ocean.add_draw(graph, at_sea, sea, light, hull, solid, hdr, depth, view.sea_visible);
  t.sky.add_background(graph, view.light, sky, hdr, depth, sky_visible);
  t.gardner.add(graph, gardner, view.light, t.sky, sky, hdr, depth);
  t.clouds.add_picture(graph, clouds, view.clouds, cloud_camera(view), t.sky, sky, hdr, depth,
                       sky_visible, wet != Lens::kSubmerged);
  t.ocean.add_spray(graph, at_sea, sea, light, hdr, depth, view.sea_visible);
  t.ocean.add_underwater(graph, view.underwater, sea, light, under, hdr);

  const BufferId exposure = t.exposure.add(graph, hdr,
                                           {.exposure = view.light.exposure,
                                            .luminance = adapting_luminance(view.light),
                                            .dt = view.frame.time.y},
                                           view.exposure);
  const double glare = std::min(view.exposure.bloom * glare_share(view.light.exposure), 0.8);
  const TextureId glow = glare > 0.0 ? t.bloom.add(graph, hdr) : TextureId{};
  t.tonemap.add(graph, hdr, display,
                {.curve = static_cast<ToneCurve>(view.exposure.curve),
                 .exposure = view.light.exposure,
                 .glow_share = glare},
                exposure, glow);
  if (t.antialias) t.antialias->add(graph, solid, depth, display);
  return display;
}

}  // namespace offing
