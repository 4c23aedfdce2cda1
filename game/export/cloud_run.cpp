#include "game/export/cloud_run.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <ctime>

#include "engine/core/paths.h"
#include "engine/gl/debug.h"
#include "game/world/sea.h"
#include "game/world/world.h"
#include "shaders/shared/bindings.h"

namespace offing {

double work_milliseconds(bool software) {
  if (software) return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>(now).count();
}

CloudRun::CloudRun(const CloudQuality& quality)
    : shaders_(data_root() / "shaders"),
      graph_(device_),
      sky_(shaders_, 2),
      field_(shaders_),
      shadow_(shaders_),
      march_(shaders_, quality),
      frame_block_("frame", sizeof(shared::FrameData)),
      software_(gl::current_renderer().software) {}

CloudRun::Ids CloudRun::prepare(const FrameView& view) {
  frame_block_.write(view.frame);
  frame_block_.bind_uniform(OFFING_BIND_FRAME);
  graph_.begin_frame();
  Ids ids;
  ids.sky = sky_.add_tables(graph_, view.light);
  shared::CloudData data = cloud_data(view.clouds, view.light);
  shadow_.plan(view.clouds, data);
  ids.field = field_.add(graph_, view.clouds, data);
  ids.shadow = shadow_.add(graph_, field_, ids.field, view.clouds);
  return ids;
}

void CloudRun::bind(const PassContext& context, const Ids& ids) const {
  sky_.bind(context, ids.sky);
  field_.bind(context, ids.field);
  shadow_.bind(context, ids.shadow);
}

void CloudRun::run(const FrameView& view, const std::function<void(FrameGraph&, const Ids&)>& add) {
  const Ids ids = prepare(view);
  add(graph_, ids);
  graph_.execute();
}

double CloudRun::march(const FrameView& view) {
  glFinish();
  const double begin = work_milliseconds(software_);
  run(view, [&](FrameGraph& graph, const Ids& ids) {
    const TextureId seen = march_.add(
        graph, field_, ids.field, sky_, ids.sky, shadow_, ids.shadow, view.clouds,
        {view.size, view.frame.clip_from_relative, view.camera, view.light.exposure}, true);
    graph.add(
        "clouds.look", [&](PassBuilder& pass) { pass.read(seen).side_effect(); },
        [this, seen](PassContext& context) { seen_ = &context.texture(seen); });
  });
  glFinish();
  return work_milliseconds(software_) - begin;
}

CloudSightings CloudRun::marched(const FrameView& view) const {
  const std::vector<float> values = seen_->read_floats(4);
  const std::vector<float> distances = march_.distances().read_floats(1);
  const auto exposure = static_cast<float>(view.light.exposure);
  const glm::ivec2 cell = march_.quality().cut_cell;
  CloudSightings clouds{view.size, {}, {}};
  for (int y = 0; y < view.size.y; ++y) {
    for (int x = 0; x < view.size.x; ++x) {
      const auto i = 4 * static_cast<std::size_t>(y * view.size.x + x);
      const glm::vec4 light(values[i], values[i + 1], values[i + 2], values[i + 3]);
      clouds.light.emplace_back(glm::vec3(light) / exposure, light.w);
      const auto nearest =
          static_cast<std::size_t>(y / cell.y * march_.distances().width() + x / cell.x);
      clouds.distance.push_back(light.w < 1.0f ? distances[nearest] : 0.0f);
    }
  }
  return clouds;
}

CloudSources CloudRun::sources(const FrameView& view) {
  const Ids ids = prepare(view);
  return {field_, ids.field, sky_, ids.sky, shadow_, ids.shadow};
}

CloudSightings CloudRun::reference(const FrameView& view, bool smoothed) {
  return CloudReference(shaders_).march(graph_, sources(view), view.size, smoothed);
}

CloudSightings CloudRun::path_trace(const FrameView& view, int samples, int first) {
  return CloudReference(shaders_).path_trace(graph_, sources(view), view.size, samples, first);
}

Image CloudRun::sky(const FrameView& view) {
  const gl::Texture hdr("sky", {.format = GL_RGBA32F, .width = view.size.x, .height = view.size.y});
  const gl::Texture depth(
      "sky depth", {.format = GL_DEPTH_COMPONENT32F, .width = view.size.x, .height = view.size.y});
  glClearTexImage(hdr.id(), 0, GL_RGBA, GL_FLOAT, nullptr);
  glClearTexImage(depth.id(), 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
  SkyLight light = view.light;
  light.sun_share = light.moon_share = light.star_share = 0.0;  // no discs
  run(view, [&](FrameGraph& graph, const Ids& ids) {
    const TextureId target = graph.import(hdr);
    sky_.add_background(graph, light, ids.sky, target, graph.import(depth), true);
    graph.add(
        "clouds.look", [&](PassBuilder& pass) { pass.read(target).side_effect(); },
        [](PassContext&) {});
  });
  Image image{view.size.x, view.size.y, 3, {}, {}};
  const std::vector<float> values = hdr.read_floats(4);
  const auto scale = static_cast<float>(1.0 / view.light.exposure);
  for (int y = view.size.y - 1; y >= 0; --y) {
    for (int x = 0; x < view.size.x; ++x) {
      const auto at = 4 * static_cast<std::size_t>(y * view.size.x + x);
      for (std::size_t c = 0; c < 3; ++c) image.pixels.push_back(values[at + c] * scale);
    }
  }
  return image;
}

FrameView still_view(Scene scene, glm::ivec2 size) {
  const DirectWater water = direct_water(scene);
  World world(std::move(scene), water);
  world.start();
  return Extractor().extract(world, size, 1.0 / 60.0, 0);
}

Image over_sky(const CloudSightings& clouds, const Image& sky) {
  Image image{sky.width, sky.height, 3, {}, {}};
  for (int y = 0; y < sky.height; ++y) {
    for (int x = 0; x < sky.width; ++x) {
      const glm::vec4 cloud =
          clouds.light[static_cast<std::size_t>((sky.height - 1 - y) * sky.width + x)];
      const auto at = 3 * static_cast<std::size_t>(y * sky.width + x);
      for (int c = 0; c < 3; ++c)
        image.pixels.push_back(cloud[c] + cloud.w * sky.pixels[at + static_cast<std::size_t>(c)]);
    }
  }
  return image;
}

}  // namespace offing
