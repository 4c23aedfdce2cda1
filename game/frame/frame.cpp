#include "game/frame/frame.h"

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

OceanView ocean_view(const FrameView& view) {
  return {view.frame.clip_from_relative, {view.camera.x, view.camera.z}, view.camera.y};
}

LightAccess light_access(const Sky& sky, const SkyIds& ids) {
  return {[ids](PassBuilder& pass) { ids.read_by(pass); },
          [&sky, ids](const PassContext& context) { sky.bind(context, ids); }};
}

}  // namespace

Techniques::Techniques(ShaderLibrary& shaders, const Quality& quality,
                       const std::filesystem::path& boat_model)
    : sky(shaders, quality.level),
      ocean(shaders, OceanSettings::of_quality(quality.level)),
      boat(shaders,
           load_model(boat_model.empty() ? data_root() / "assets/models/r8/r8.glb" : boat_model,
                      kBoatNodeNames),
           load_boat_textures(data_root() / "assets/textures")),
      flotsam(shaders, load_model(data_root() / "assets/models/flotsam/flotsam.glb", kFlotsam)),
      tonemap(shaders),
      frame_block("frame", sizeof(shared::FrameData)) {}

FramePictures::FramePictures(glm::ivec2 size)
    : hdr("hdr", {.format = GL_RGBA16F, .width = size.x, .height = size.y}),
      depth("depth", {.format = GL_DEPTH_COMPONENT32F, .width = size.x, .height = size.y}),
      display("display", {.format = GL_RGBA8, .width = size.x, .height = size.y}) {}

TextureId build_frame(FrameGraph& graph, const FrameView& view, Techniques& t,
                      const FramePictures& pictures) {
  const TextureId hdr = graph.import(pictures.hdr);
  const TextureId depth = graph.import(pictures.depth);
  const TextureId display = graph.import(pictures.display);

  add_begin(graph, view, t.frame_block, hdr, depth);
  const SkyIds sky = t.sky.add_tables(graph, view.light);
  const SeaIds sea = t.ocean.add_maps(graph, view.sea_time);
  const TextureId hull = t.boat.add_mask(graph, view.boat, view.frame);
  t.boat.add(graph, view.boat, view.frame, light_access(t.sky, sky), hdr, depth);
  t.flotsam.add(graph, view.flotsam, view.frame, light_access(t.sky, sky), hdr, depth);
  t.ocean.add_draw(graph, ocean_view(view), sea, light_access(t.sky, sky), hull, hdr, depth,
                   view.sea_visible);
  t.sky.add_background(graph, view.light, sky, hdr, depth, view.sky_visible);
  t.tonemap.add(graph, hdr, display, {.exposure = view.light.exposure, .count_nonfinite = true});
  return display;
}

}  // namespace offing
