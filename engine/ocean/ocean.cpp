#include "engine/ocean/ocean.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/angles.h"
#include "engine/environment/gust_field.h"
#include "engine/gl/debug.h"
#include "engine/ocean/crossfade.h"
#include "engine/ocean/fft_moments.h"
#include "engine/ocean/foam_pattern.h"
#include "engine/ocean/roughness_table.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/ocean.h"

#define OFFING_GLSL "shaders/lib/water.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

constexpr double kAtOnce = std::numeric_limits<double>::infinity();
constexpr std::size_t kMaxSquares = 8192;
constexpr double kFoamLength = 7.3;  // m across the wind; no multiple of a cascade's length
constexpr int kFoamTexels = 256;
constexpr int kHorizonTexels = 256;         // of the sky's strip
constexpr double kTallestWave = 1.5;        // over Hs: none in a day's 10 000 waves is higher
constexpr double kFarthestInWater = 250.0;  // m: no surface is seen from below beyond that

/// Foam lies in rows from force 7 on.
double streaks(double wind) {
  const double t = std::clamp((wind - 11.0) / 6.0, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double fraction(double x) { return x - std::floor(x); }

ShaderDefines mesh_defines(const OceanSettings& settings) {
  return {{"MORPH", std::to_string(SeaMesh::kMorph)},
          {"FOOTPRINT_RATIO", settings.mesh_cells <= 8 ? "4.0" : "3.0"}};
}

ShaderDefines two_sided(ShaderDefines defines) {
  defines.emplace_back("TWO_SIDED", "1");
  return defines;
}

ShaderDefines surface_defines(const OceanSettings& settings, bool hull) {
  ShaderDefines defines{{"CASCADES", std::to_string(settings.cascades)}};
  if (hull) defines.emplace_back("HULL", "");
  if (hull && settings.quality > 0) defines.emplace_back("HULL_SHADOW", "");
  if (settings.quality <= 0) defines.emplace_back("PICK_LEVELS", "");
  if (gl::current_renderer().software) defines.emplace_back("FLAT_OCEAN", "");
  return defines;
}

glm::vec4 rgb(glm::dvec3 v, double w = 0.0) { return glm::vec4(glm::dvec4(v, w)); }

gl::Texture make_gusts() {
  gl::Texture texture("sea.gusts",
                      {.format = GL_R16F, .width = GustField::kSize, .height = GustField::kSize});
  texture.upload(GL_RED, GL_FLOAT, gust_field().grid().data());
  return texture;
}

}  // namespace

OceanSettings OceanSettings::of_quality(int quality) {
  OceanSettings settings;
  settings.quality = quality;
  settings.size = quality <= 0 ? 128 : 256;
  settings.mesh_cells = quality <= 0 ? 8 : quality == 1 ? 14 : quality == 2 ? 22 : 32;
  settings.cascades = quality <= 0 ? 3 : quality <= 2 ? 4 : 5;
  settings.foam_size = quality <= 0 ? 128 : 256;
  return settings;
}

Ocean::Ocean(ShaderLibrary& shaders, const OceanSettings& settings)
    : settings_(settings),
      shaders_(shaders),
      maps_(shaders, settings.cascades, settings.size),
      water_(std::make_unique<FftMoments>()),
      mesh_{.cells = settings.mesh_cells, .finest_spacing = 3.2 / settings.mesh_cells},
      mesh_program_(
          shaders.program({"ocean/mesh.vert", "ocean/mesh.frag"}, mesh_defines(settings))),
      two_sided_mesh_program_(shaders.program({"ocean/mesh.vert", "ocean/mesh.frag"},
                                              two_sided(mesh_defines(settings)))),
      surface_(shaders.program({"ocean/surface.vert", "ocean/surface.frag"},
                               surface_defines(settings, false))),
      surface_over_hull_(shaders.program({"ocean/surface.vert", "ocean/surface.frag"},
                                         surface_defines(settings, true))),
      horizon_(shaders.program({"post/full_screen.vert", "ocean/air.frag"})),
      squares_("sea.squares", kMaxSquares * sizeof(SeaMesh::Square)),
      block_("sea.block", sizeof(shared::OceanData)),
      array_("sea.mesh"),
      no_vertices_("sea.picture"),
      map_sampler_("sea.map", GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_REPEAT, GL_REPEAT),
      level_sampler_("sea.level", GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR, GL_REPEAT, GL_REPEAT),
      foam_sampler_("sea.foam", GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_REPEAT, GL_REPEAT),
      line_sampler_("sea.lines", GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE),
      wrap_sampler_("sea.wrapped", GL_LINEAR, GL_LINEAR, GL_REPEAT, GL_REPEAT),
      foam_(make_foam_pattern(kFoamTexels)),
      gusts_(make_gusts()),
      squalls_("sea.squalls", {.format = GL_R16F}),
      roughness_("sea.roughness",
                 {.format = GL_RGBA32F, .width = shared::kRoughnessEntries, .height = 1}),
      foam_map_(shaders, settings.foam_size),
      underwater_(shaders, settings.quality) {
  make_grid();
}

void Ocean::make_grid() {
  const int n = settings_.mesh_cells;
  std::vector<float> corners;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      corners.push_back(static_cast<float>(i));
      corners.push_back(static_cast<float>(j));
    }
  }
  std::vector<std::uint32_t> indices;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const auto a = static_cast<std::uint32_t>(j * (n + 1) + i);
      const auto b = a + 1, c = a + static_cast<std::uint32_t>(n) + 1, d = c + 1;
      indices.insert(indices.end(), {a, c, b, b, c, d});
    }
  }
  vertices_ = gl::Buffer::of<float>("sea.corners", corners);
  indices_ = gl::Buffer::of<std::uint32_t>("sea.indices", indices);
  index_count_ = static_cast<int>(indices.size());
  array_.attribute(0, 2, vertices_.id(), 2 * sizeof(float), 0);
  array_.attribute(1, 4, squares_.id(), sizeof(SeaMesh::Square), 0);
  glVertexArrayBindingDivisor(array_.id(), 1, 1);
  array_.index_buffer(indices_.id());
}

void Ocean::set_sea(const SeaState& state, const Environment& environment, std::uint64_t seed) {
  choose_queries(state.queries);
  const std::uint64_t key = key_of(state, environment, seed);
  if (!cascades_.empty() && key == sea_key_) return;
  sea_key_ = key;
  fading_ = false;
  show(make_sea(state, environment, seed, settings_.cascades, settings_.size));
  water_.set_waves(query_waves(cascades_), choppiness_, kAtOnce);
}

void Ocean::turn_to(const SeaState& state, const Environment& environment, std::uint64_t seed,
                    double time) {
  if (cascades_.empty()) return set_sea(state, environment, seed);
  choose_queries(state.queries);
  const std::uint64_t key = key_of(state, environment, seed);
  if (key == sea_key_ || fading_) return;
  sea_key_ = key;
  from_ = {cascades_,    statistics_, slope_variance_, choppiness_,
           white_share_, wind_speed_, wind_to_};
  to_ = make_sea(state, environment, seed, settings_.cascades, settings_.size);
  fading_ = true;
  begin_ = time + GpuMoments::kAhead;  // until then the new waves can be known on the CPU
  water_.set_waves(query_waves(to_.cascades), to_.choppiness, begin_);
}

std::shared_ptr<const QueryWaves> Ocean::query_waves(std::span<const Cascade> cascades) const {
  return std::make_shared<const QueryWaves>(cascades,
                                            std::min(settings_.query_cascades, settings_.cascades));
}

void Ocean::choose_queries(int method) {
  if (method == queries_) return;
  queries_ = method;
  gpu_moments_ = nullptr;
  if (method == kReadbackQueries) {
    auto moments = std::make_unique<GpuMoments>(shaders_);
    gpu_moments_ = moments.get();
    water_.set_source(std::move(moments));
  } else {
    water_.set_source(std::make_unique<FftMoments>());
  }
}

void Ocean::fade(double time) {
  if (!fading_ || time < begin_) return;
  if (time < begin_ + kCrossfadeSeconds) return show(blend(from_, to_, time - begin_));
  fading_ = false;
  show(std::move(to_));
  from_ = to_ = {};
}

void Ocean::show(Sea sea) {
  cascades_ = std::move(sea.cascades);
  statistics_ = sea.statistics;
  slope_variance_ = sea.slope_variance;
  choppiness_ = sea.choppiness;
  white_share_ = sea.white_share;
  wind_speed_ = sea.wind_speed;
  wind_to_ = sea.wind_to;
  maps_.set_waves(cascades_, choppiness_);
  foam_law_ = foam_law(cascades_, choppiness_, white_share_);
  roughness_.upload(GL_RGBA, GL_FLOAT, roughness_table(cascades_, slope_variance_).data());
  ++shown_;
}

void Ocean::prime(FrameGraph& graph, double time) {
  constexpr int kMostFrames = 16;
  const auto known = [&] {
    return water_.age(time) == 0.0 && water_.age(time + GpuMoments::kAhead) == 0.0;
  };
  for (int frame = 0; frame < kMostFrames && !known(); ++frame) {
    graph.begin_frame();
    add_maps(graph, time);
    graph.execute();
    glFinish();
    collect();
  }
}

void Ocean::collect() {
  if (gpu_moments_ != nullptr) gpu_moments_->collect();
}

double Ocean::carried_variance() const {
  double sum = 0.0;
  for (const Cascade& cascade : cascades_) sum += cascade.variance;
  return sum;
}

SeaIds Ocean::add_maps(FrameGraph& graph, double time, bool readback) {
  fade(time);
  const SeaIds ids = maps_.add(graph, time);
  if (readback && gpu_moments_ != nullptr) gpu_moments_->add(graph, time);
  return ids;
}

void Ocean::update_block(const OceanView& view) {
  shared::OceanData data{};
  for (std::size_t c = 0; c < cascades_.size(); ++c) {
    const Cascade& cascade = cascades_[c];
    const double x = std::cos(cascade.band.angle) / cascade.band.length;
    const double z = std::sin(cascade.band.angle) / cascade.band.length;
    const double point = cascade.band.length / cascade.size;
    data.grid[c] = glm::vec4(glm::dvec4(x, z, std::log2(point), 0));
    // Map points lie at whole indices: shift by half a texel. Whole periods are dropped in double.
    const double half = 0.5 / cascade.size;
    data.origin[c] = glm::vec4(glm::dvec4(fraction(x * view.eye.x + z * view.eye.y + half),
                                          fraction(x * view.eye.y - z * view.eye.x + half), 0, 0));
  }
  data.water = glm::vec4(glm::dvec4(statistics_.hs, settings_.cascades,
                                    SeaMesh::kReach * settings_.mesh_cells, mesh_.finest_spacing));

  data.foam = glm::vec4(glm::dvec4(foam_law_.birth, foam_law_.present, breaking_cascades(cascades_),
                                   foam_law_.softness));
  data.foam_share =
      glm::vec4(glm::dvec4(white_share_, std::max(white_share_ / foam_law_.breaking, 1.0),
                           foam_law_.variance, streaks(wind_speed_)));
  for (int layer = 0; layer < shared::kFoamLayers; ++layer) {
    const double width = foam_map_.width(layer);
    data.foam_map[layer] = glm::vec4(
        glm::dvec4(fraction(view.eye.x / width), fraction(view.eye.y / width), 1.0 / width, 0));
  }
  // Wind draws foam out into streaks. The pattern is read at several scales, all eighths.
  const double stretch = 1.0 + wind_speed_ / 8.0;
  const glm::dvec2 along = wind_to_ / (kFoamLength * stretch);
  const double u = glm::dot(along, view.eye);
  const double v = stretch * (along.x * view.eye.y - along.y * view.eye.x);
  data.foam_grid =
      glm::vec4(glm::dvec4(8.0 * fraction(u / 8.0), 8.0 * fraction(v / 8.0), along.x, along.y));
  data.foam_stretch = glm::vec4(glm::dvec4(stretch, stretch * kFoamTexels, 0, 0));

  const glm::dvec2 gust = (view.eye - view.gust_origin) / GustField::kPeriod;
  data.gust = glm::vec4(glm::dvec4(fraction(gust.x), fraction(gust.y), 1.0 / GustField::kPeriod,
                                   GustField::kIntensity * view.gusts));
  if (view.squalls && view.squalls->any()) {
    const double period = view.squalls->period();
    const glm::dvec2 squall = (view.eye - view.squall_corner) / period;
    data.squall = glm::vec4(glm::dvec4(fraction(squall.x), fraction(squall.y), 1.0 / period, 1.0));
  }

  const glsl::WaterOptics body = glsl::water_optics(view.chlorophyll);
  const glm::dvec3 extinction = body.absorption + 30.0 * body.backscatter;
  // Irradiance reflectance .33 bb / (a + bb) (Gordon et al. 1975) and the way through the surface
  // and back, .54.
  data.body = rgb(0.54 * 0.33 / kPi * body.backscatter / (body.absorption + body.backscatter));
  data.crest_thin = rgb(glm::exp(-1.2 * extinction));
  data.crest_thick = rgb(glm::exp(-9.0 * extinction));
  data.absorption = rgb(body.absorption);
  data.backscatter = rgb(body.backscatter);
  block_.write(data);
}

void Ocean::bind_surface(const PassContext& context, const SeaIds& sea) const {
  context.texture(sea.displacement).bind(0);
  context.texture(sea.slopes).bind(1);
  foam_.bind(2);
  roughness_.bind(OFFING_UNIT_SEA_ROUGHNESS);
  map_sampler_.bind(0);
  map_sampler_.bind(1);
  foam_sampler_.bind(2);
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
                            GLuint{OFFING_UNIT_FOAM}, GLuint{OFFING_UNIT_SEA_ROUGHNESS}}) {
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

UnderwaterIds Ocean::add_draw(FrameGraph& graph, const OceanView& view, const SeaIds& sea,
                              const LightAccess& sky, TextureId dry, TextureId hdr, TextureId depth,
                              bool visible) {
  const bool wet = view.lens != Lens::kDry;
  const bool submerged = view.lens == Lens::kSubmerged;
  std::vector<SeaMesh::Square> squares;
  if (visible || wet) {
    squares = mesh_.select(view.eye, view.eye_height, 1.2 * statistics_.hs + 0.1,
                           view.clip_from_relative, submerged ? kFarthestInWater : kAtOnce);
    if (squares.size() > kMaxSquares) squares.resize(kMaxSquares);
  }
  const bool nothing_in_view = squares.empty();
  show_squalls(view.squalls);
  gl::TextureDesc seen_desc = graph.desc(hdr);
  const TextureId hull = graph.create("sea.hull", seen_desc);
  seen_desc.format = GL_RGBA32F;
  const TextureId seen = graph.create("sea.seen", seen_desc);
  UnderwaterIds ids{.lens = view.lens, .solid = {}, .below = seen, .beyond = {}};
  ids.solid = underwater_.add_solid(graph, depth, wet);
  const TextureId foam = add_foam(graph, view, sea, !nothing_in_view || wet);

  graph.add(
      "sea.mesh",
      [&](PassBuilder& pass) {
        pass.read(sea.displacement).read(dry);
        pass.write(seen, Access::kAttachment).modify(depth).render_to({seen}, depth);
        pass.skip_if(nothing_in_view && !wet);
      },
      [this, sea, dry, wet, squares = std::move(squares)](const PassContext& context) {
        squares_.write(squares.data(), squares.size() * sizeof(SeaMesh::Square));
        const float nowhere[4] = {0.0f, 0.0f, 0.0f, 0.0f};
        glClearBufferfv(GL_COLOR, 0, nowhere);
        context.texture(sea.displacement).bind(0);
        context.texture(dry).bind(3);
        map_sampler_.bind(0);
        block_.bind_uniform(OFFING_BIND_OCEAN);
        (wet ? two_sided_mesh_program_ : mesh_program_).use();
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_GREATER);
        glDepthMask(GL_TRUE);
        glDisable(GL_CULL_FACE);
        glDisable(GL_BLEND);
        array_.bind();
        glDrawElementsInstanced(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr,
                                static_cast<GLsizei>(squares.size()));
        glDisable(GL_DEPTH_TEST);
        glBindSampler(0, 0);
      });

  // A lens half in the water: the sea is drawn from above where a pixel is dry.
  const SurfaceAccess surface = surface_access(sea, foam);
  const TextureId above = underwater_.add_split(graph, surface, seen, &ids);
  // What stands in the water, as it looks without the water.
  const bool hull_shows = view.hull_in_view && !nothing_in_view;
  graph.add(
      "sea.hull",
      [&](PassBuilder& pass) {
        pass.read(hdr, Access::kTransfer).write(hull, Access::kTransfer);
        pass.skip_if(!hull_shows);
      },
      [hdr, hull](const PassContext& context) {
        const gl::Texture &from = context.texture(hdr), &to = context.texture(hull);
        glCopyImageSubData(from.id(), GL_TEXTURE_2D, 0, 0, 0, 0, to.id(), GL_TEXTURE_2D, 0, 0, 0, 0,
                           from.width(), from.height(), 1);
      });

  const TextureId horizon =
      graph.create("sea.air", {.format = GL_RGBA32F, .width = kHorizonTexels, .height = 1});
  graph.add(
      "sea.air",
      [&](PassBuilder& pass) {
        sky.declare(pass);
        pass.write(horizon, Access::kAttachment).render_to({horizon});
        pass.skip_if(nothing_in_view || submerged);
      },
      [this, bind_sky = sky.bind](const PassContext& context) {
        bind_sky(context);
        horizon_.use();
        horizon_.program().set(0, static_cast<float>(kHorizonTexels));
        glDisable(GL_DEPTH_TEST);
        glDisable(GL_BLEND);
        no_vertices_.bind();
        glDrawArrays(GL_TRIANGLES, 0, 3);
      });

  graph.add(
      "sea.draw",
      [&](PassBuilder& pass) {
        pass.read(sea.displacement).read(sea.slopes).read(above).read(foam).read(horizon);
        if (hull_shows) pass.read(hull).read(dry);
        sky.declare(pass);
        pass.read(depth, Access::kAttachment).modify(hdr).render_to({hdr}, depth);
        pass.skip_if(nothing_in_view || submerged);
      },
      [this, sea, above, foam, horizon, dry, hull, hull_shows,
       bind_sky = sky.bind](const PassContext& context) {
        bind_surface(context, sea);
        if (settings_.quality <= 0) {  // whole levels: see sea_map_level_picked()
          level_sampler_.bind(0);
          level_sampler_.bind(1);
          level_sampler_.bind(2);
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
        (hull_shows ? surface_over_hull_ : surface_).use();
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

void Ocean::add_underwater(FrameGraph& graph, const UnderwaterView& view, const SeaIds& sea,
                           const LightAccess& sky, const UnderwaterIds& ids, TextureId hdr) const {
  underwater_.add(graph, view, surface_access(sea, graph.import(foam_map_.map())), sky, ids, hdr);
}

}  // namespace offing
