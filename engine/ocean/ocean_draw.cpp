#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/ocean/ocean.h"
#include "shaders/shared/bindings.h"

namespace offing {
namespace {

constexpr double kAnyDistance = std::numeric_limits<double>::infinity();
constexpr double kTallestWave = 1.5;        // over Hs: none in a day's 10 000 waves is higher
constexpr double kFarthestInWater = 250.0;  // m: no surface is seen from below beyond that

}  // namespace

void Ocean::bind_surface(const PassContext& context, const SeaIds& sea) const {
  context.texture(sea.displacement).bind(0);
  context.texture(sea.slopes).bind(1);
  foam_.bubbles.bind(2);
  foam_.lace.bind(OFFING_UNIT_FOAM_LACE);
  foam_.rows.bind(OFFING_UNIT_FOAM_ROWS);
  roughness_.bind(OFFING_UNIT_SEA_ROUGHNESS);
  map_sampler_.bind(0);
  map_sampler_.bind(1);
  for (const GLuint unit : {2u, GLuint{OFFING_UNIT_FOAM_LACE}, GLuint{OFFING_UNIT_FOAM_ROWS}}) {
    foam_sampler_.bind(unit);
  }
  line_sampler_.bind(OFFING_UNIT_SEA_ROUGHNESS);
  block_.bind_uniform(OFFING_BIND_OCEAN);
}

void Ocean::show_squalls(const std::shared_ptr<const SquallField>& squalls) {
  if (!squalls || !squalls->any() || squalls == squalls_shown_) return;
  const gl::TextureDesc desc{
      .format = GL_R16F, .width = squalls->size(), .height = squalls->size()};
  if (squalls_.desc() != desc) squalls_ = gl::Texture("sea.squalls", desc);
  squalls_.upload(GL_RED, GL_FLOAT, squalls->strength().data());
  squalls_shown_ = squalls;
}

void Ocean::unbind_samplers() {
  for (const GLuint unit : {0u, 1u, 2u, 4u, GLuint{OFFING_UNIT_GUSTS}, GLuint{OFFING_UNIT_SQUALLS},
                            GLuint{OFFING_UNIT_FOAM}, GLuint{OFFING_UNIT_SEA_ROUGHNESS},
                            GLuint{OFFING_UNIT_FOAM_LACE}, GLuint{OFFING_UNIT_FOAM_ROWS}}) {
    glBindSampler(unit, 0);
  }
}

Lens Ocean::lens(glm::dvec3 eye, std::span<const glm::vec3> corners, double time) const {
  const double crests = kTallestWave * statistics_.hs + 0.2;
  const auto [lowest, highest] =
      std::minmax_element(corners.begin(), corners.end(),
                          [](const glm::vec3& a, const glm::vec3& b) { return a.y < b.y; });
  const double low = eye.y + static_cast<double>(lowest->y);
  const double high = eye.y + static_cast<double>(highest->y);
  if (low > crests) return Lens::kDry;
  if (high < -crests) return Lens::kSubmerged;
  if (fading_ || water_.age(time) > 0.0) return Lens::kCrossing;

  std::vector<glm::dvec2> places;
  for (const glm::vec3& corner : corners) {
    places.emplace_back(eye.x + static_cast<double>(corner.x),
                        eye.z + static_cast<double>(corner.z));
  }
  std::vector<WaterSample> water(places.size());
  water_.sample(places, time, water);
  double unknown = 0.0;  // variance of the waves that queries leave out
  for (std::size_t c = static_cast<std::size_t>(settings_.query_cascades); c < cascades_.size();
       ++c) {
    unknown += cascades_[c].variance;
  }
  const double margin = 5.0 * std::sqrt(unknown) + 0.03;
  bool all_above = true, all_below = true;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double over = eye.y + static_cast<double>(corners[i].y) - water[i].height;
    all_above = all_above && over > margin;
    all_below = all_below && over < -margin;
  }
  return all_above ? Lens::kDry : all_below ? Lens::kSubmerged : Lens::kCrossing;
}

TextureId Ocean::add_foam(FrameGraph& graph, const OceanView& view, const SeaIds& sea,
                          bool visible) {
  if (visible) update_block(view);
  return foam_map_.add(graph, sea, view.eye, view.time, shown_, visible,
                       [this, sea](const PassContext& context) { bind_surface(context, sea); });
}

void Ocean::add_mesh(FrameGraph& graph, const OceanView& view, const SeaIds& sea,
                     std::vector<SeaMesh::Square> squares, TextureId dry, TextureId seen,
                     TextureId depth) {
  const bool wet = view.lens != Lens::kDry;
  const bool nothing_in_view = squares.empty();
  const bool about_hull = view.hull_in_view || wet;
  graph.add(
      "sea.mesh",
      [&](PassBuilder& pass) {
        pass.read(sea.displacement);
        if (about_hull) pass.read(dry);
        pass.write(seen, Access::kAttachment).modify(depth).render_to({seen}, depth);
        pass.skip_if(nothing_in_view && !wet);
      },
      [this, sea, dry, wet, about_hull, squares = std::move(squares)](const PassContext& context) {
        squares_.write(squares.data(), squares.size() * sizeof(SeaMesh::Square));
        const float nowhere[4] = {0.0f, 0.0f, 0.0f, 0.0f};
        glClearBufferfv(GL_COLOR, 0, nowhere);
        context.texture(sea.displacement).bind(0);
        if (about_hull) context.texture(dry).bind(3);
        map_sampler_.bind(0);
        block_.bind_uniform(OFFING_BIND_OCEAN);
        (wet ? two_sided_mesh_program_ : about_hull ? mesh_about_hull_ : mesh_program_).use();
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_GREATER);
        glDepthMask(GL_TRUE);
        // Far waves turn many backs. (What is folded over a crest goes with them: the sea lies
        // under it.)
        (wet ? glDisable : glEnable)(GL_CULL_FACE);
        glCullFace(GL_BACK);
        glFrontFace(GL_CCW);
        glDisable(GL_BLEND);
        array_.bind();
        glDrawElementsInstanced(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr,
                                static_cast<GLsizei>(squares.size()));
        glDisable(GL_CULL_FACE);
        glDisable(GL_DEPTH_TEST);
        glBindSampler(0, 0);
      });
}

void Ocean::add_hull(FrameGraph& graph, TextureId hdr, TextureId hull, bool shows) {
  graph.add(
      "sea.hull",
      [&](PassBuilder& pass) {
        pass.read(hdr, Access::kTransfer).write(hull, Access::kTransfer);
        pass.skip_if(!shows);
      },
      [hdr, hull](const PassContext& context) {
        const gl::Texture &from = context.texture(hdr), &to = context.texture(hull);
        glCopyImageSubData(from.id(), GL_TEXTURE_2D, 0, 0, 0, 0, to.id(), GL_TEXTURE_2D, 0, 0, 0, 0,
                           from.width(), from.height(), 1);
      });
}

TextureId Ocean::add_horizon(FrameGraph& graph, const LightAccess& sky, bool visible) const {
  const TextureId horizon =
      graph.create("sea.air", {.format = GL_RGBA32F, .width = shared::kHorizonTexels, .height = 1});
  graph.add(
      "sea.air",
      [&](PassBuilder& pass) {
        sky.declare(pass);
        pass.write(horizon, Access::kAttachment).render_to({horizon});
        pass.skip_if(!visible);
      },
      [this, bind_sky = sky.bind](const PassContext& context) {
        bind_sky(context);
        horizon_.use();
        horizon_.program().set(0, static_cast<float>(shared::kHorizonTexels));
        glDisable(GL_DEPTH_TEST);
        glDisable(GL_BLEND);
        no_vertices_.bind();
        glDrawArrays(GL_TRIANGLES, 0, 3);
      });
  return horizon;
}

UnderwaterIds Ocean::add_draw(FrameGraph& graph, const OceanView& view, const SeaIds& sea,
                              const LightAccess& sky, TextureId dry, TextureId solid, TextureId hdr,
                              TextureId depth, bool visible) {
  const bool wet = view.lens != Lens::kDry;
  const bool submerged = view.lens == Lens::kSubmerged;
  std::vector<SeaMesh::Square> squares;
  if (visible || wet) {
    squares = mesh_.select(view.eye, view.eye_height, 1.2 * statistics_.hs + 0.1,
                           view.clip_from_relative, submerged ? kFarthestInWater : kAnyDistance);
    if (squares.size() > SeaMesh::kMostSquares) squares.resize(SeaMesh::kMostSquares);
  }
  const bool nothing_in_view = squares.empty();
  show_squalls(view.squalls);
  gl::TextureDesc seen_desc = graph.desc(hdr);
  const TextureId hull = graph.create("sea.hull", seen_desc);
  seen_desc.format = GL_RGBA32F;
  const TextureId seen = graph.create("sea.seen", seen_desc);
  UnderwaterIds ids{.lens = view.lens, .solid = solid, .below = seen, .beyond = {}};
  const TextureId foam = add_foam(graph, view, sea, !nothing_in_view || wet);

  add_mesh(graph, view, sea, std::move(squares), dry, seen, depth);

  // A lens half in the water: the sea is drawn from above where a pixel is dry.
  const SurfaceAccess surface = surface_access(sea, foam);
  const TextureId above = underwater_.add_split(graph, surface, seen, &ids);
  // What stands in the water, as it looks without the water.
  const bool hull_shows = view.hull_in_view && !nothing_in_view;
  add_hull(graph, hdr, hull, hull_shows);
  const TextureId horizon = add_horizon(graph, sky, !nothing_in_view && !submerged);

  const ShaderProgram& program = surface_program({.hull = hull_shows,
                                                  .squalls = view.squalls && view.squalls->any(),
                                                  .streaks = streaks() > 0.0,
                                                  .clouds = view.clouds});

  graph.add(
      "sea.draw",
      [&](PassBuilder& pass) {
        pass.read(sea.displacement).read(sea.slopes).read(above).read(foam).read(horizon);
        if (hull_shows) pass.read(hull).read(dry);
        sky.declare(pass);
        pass.read(depth, Access::kAttachment).modify(hdr).render_to({hdr}, depth);
        pass.skip_if(nothing_in_view || submerged);
      },
      [this, sea, above, foam, horizon, dry, hull, hull_shows, &surface = program,
       bind_sky = sky.bind](const PassContext& context) {
        bind_surface(context, sea);
        if (settings_.quality <= 0) {  // whole levels: see sea_map_level_picked()
          level_sampler_.bind(0);
          level_sampler_.bind(1);
          level_sampler_.bind(OFFING_UNIT_FOAM_LACE);
          level_sampler_.bind(OFFING_UNIT_FOAM_ROWS);
        }
        context.texture(above).bind(3);
        context.texture(horizon).bind(4);
        wrap_sampler_.bind(4);
        if (hull_shows) {
          context.texture(dry).bind(5);
          context.texture(hull).bind(6);
        }
        gusts_.bind(OFFING_UNIT_GUSTS);
        squalls_.bind(OFFING_UNIT_SQUALLS);
        wrap_sampler_.bind(OFFING_UNIT_SQUALLS);
        wrap_sampler_.bind(OFFING_UNIT_GUSTS);
        context.texture(foam).bind(OFFING_UNIT_FOAM);
        wrap_sampler_.bind(OFFING_UNIT_FOAM);
        bind_sky(context);
        surface.use();
        // Infinitely far away, and only where something is nearer: no work for the sky's pixels.
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LESS);
        glDepthMask(GL_FALSE);
        glDisable(GL_BLEND);
        no_vertices_.bind();
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glDisable(GL_DEPTH_TEST);
        unbind_samplers();
      });
  return ids;
}

SurfaceAccess Ocean::surface_access(const SeaIds& sea, TextureId foam) const {
  return {
      [sea, foam](PassBuilder& pass) { pass.read(sea.displacement).read(sea.slopes).read(foam); },
      [this, sea, foam](const PassContext& context) {
        bind_surface(context, sea);
        context.texture(foam).bind(OFFING_UNIT_FOAM);
        wrap_sampler_.bind(OFFING_UNIT_FOAM);
      },
      [] { unbind_samplers(); }};
}

void Ocean::add_spray(FrameGraph& graph, const OceanView& view, const SeaIds& sea,
                      const LightAccess& sky, TextureId hdr, TextureId depth, bool visible) {
  spray_.add(graph,
             {.eye = view.eye,
              .time = view.time,
              .wind_speed = wind_speed_,
              .visible = visible && view.lens != Lens::kSubmerged},
             surface_access(sea, graph.import(foam_map_.map())), sky, hdr, depth);
}

void Ocean::add_underwater(FrameGraph& graph, const UnderwaterView& view, const SeaIds& sea,
                           const LightAccess& sky, const UnderwaterIds& ids, TextureId hdr) const {
  underwater_.add(graph, view, surface_access(sea, graph.import(foam_map_.map())), sky, ids, hdr);
}

}  // namespace offing
