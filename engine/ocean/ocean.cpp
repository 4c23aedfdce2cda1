#include "engine/ocean/ocean.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/angles.h"
#include "engine/environment/gust_field.h"
#include "engine/gl/debug.h"
#include "engine/ocean/crossfade.h"
#include "engine/ocean/fft_moments.h"
#include "engine/ocean/roughness_table.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/ocean.h"

#define OFFING_GLSL "shaders/lib/crest.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/water.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

constexpr double kAtOnce = std::numeric_limits<double>::infinity();
constexpr double kFoamLength = 7.3;  // m across the wind; no multiple of a cascade's length

double fraction(double x) { return x - std::floor(x); }

ShaderDefines mesh_defines(const OceanSettings& settings, bool hull, bool two_sided) {
  ShaderDefines defines{{"MORPH", std::to_string(SeaMesh::kMorph)},
                        {"FOOTPRINT_RATIO", settings.mesh_cells <= 8 ? "4.0" : "3.0"}};
  if (hull) defines.emplace_back("HULL", "");
  if (two_sided) defines.emplace_back("TWO_SIDED", "");
  return defines;
}

ShaderDefines surface_defines(const OceanSettings& settings) {
  ShaderDefines defines{{"CASCADES", std::to_string(settings.cascades)}};
  if (settings.quality <= 0) {
    defines.emplace_back("PICK_LEVELS", "");
    defines.emplace_back("RIPPLES", "");
  }
  if (gl::current_renderer().software) defines.emplace_back("FLAT_OCEAN", "");
  return defines;
}

glm::vec4 rgb(glm::dvec3 v, double w = 0.0) { return glm::vec4(glm::dvec4(v, w)); }

gl::Texture make_gusts() {
  static_assert(GustField::kSize == shared::kGustTexels);
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
      mesh_program_(shaders.program({"ocean/mesh.vert", "ocean/mesh.frag"},
                                    mesh_defines(settings, false, false))),
      mesh_about_hull_(shaders.program({"ocean/mesh.vert", "ocean/mesh.frag"},
                                       mesh_defines(settings, true, false))),
      two_sided_mesh_program_(shaders.program({"ocean/mesh.vert", "ocean/mesh.frag"},
                                              mesh_defines(settings, true, true))),
      horizon_(shaders.program({"post/full_screen.vert", "ocean/air.frag"})),
      squares_("sea.squares", SeaMesh::kMostSquares * sizeof(SeaMesh::Square)),
      block_("sea.block", sizeof(shared::OceanData)),
      array_("sea.mesh"),
      no_vertices_("sea.picture"),
      map_sampler_("sea.map", GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_REPEAT, GL_REPEAT),
      level_sampler_("sea.level", GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR, GL_REPEAT, GL_REPEAT),
      foam_sampler_("sea.foam", GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_REPEAT, GL_REPEAT),
      line_sampler_("sea.lines", GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE),
      wrap_sampler_("sea.wrapped", GL_LINEAR, GL_LINEAR, GL_REPEAT, GL_REPEAT),
      foam_(make_foam_patterns()),
      gusts_(make_gusts()),
      squalls_("sea.squalls", {.format = GL_R16F}),
      roughness_("sea.roughness",
                 {.format = GL_RGBA32F, .width = shared::kRoughnessEntries, .height = 1}),
      foam_map_(shaders, settings.foam_size),
      spray_(shaders, settings.quality),
      underwater_(shaders, settings.quality) {
  make_grid();
  surface_program({.hull = false, .squalls = false, .streaks = false, .clouds = true});
  surface_program({.hull = true, .squalls = false, .streaks = false, .clouds = true});
}

const ShaderProgram& Ocean::surface_program(const Shows& shows) {
  // A GPU leaves out what an `if` says: no need of programs without streaks or clouds.
  const bool all = !gl::current_renderer().software;
  const bool streaks = shows.streaks || all, clouds = shows.clouds || all;
  const unsigned key =
      (shows.hull ? 1u : 0u) | (shows.squalls ? 2u : 0u) | (streaks ? 4u : 0u) | (clouds ? 8u : 0u);
  const ShaderProgram*& program = surface_[key];
  if (program == nullptr) {
    ShaderDefines defines = surface_defines(settings_);
    if (shows.hull) defines.emplace_back("HULL", "");
    if (shows.hull && settings_.quality > 0) defines.emplace_back("HULL_SHADOW", "");
    if (shows.squalls) defines.emplace_back("SQUALLS", "");
    if (streaks) defines.emplace_back("STREAKS", "");
    if (clouds) defines.emplace_back("CLOUDS", "");
    program = &shaders_.program({"ocean/surface.vert", "ocean/surface.frag"}, defines);
  }
  return *program;
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
  ripples_ = settings_.quality <= 0 ? ripple_share(cascades_, slope_variance_) : 0.0;
  const std::vector<glm::vec4> missing = roughness_table(cascades_, slope_variance_, ripples_);
  roughness_.upload(GL_RGBA, GL_FLOAT, missing.data());
  // What the foam map's layers do not show of the breaking waves where each ends: of the innermost,
  // then what each has more.
  constexpr double kCellHere =
      1.6;  // in the next layer, half of the way there, cells are 4 times as wide
  float before = 0.0f;
  for (std::size_t layer = 0; layer < foam_crest_.size(); ++layer) {
    const double size_log2 =
        std::log2(kCellHere * foam_map_.width(static_cast<int>(layer)) / settings_.foam_size);
    const double entry = (size_log2 - shared::kRoughnessFirst) * shared::kRoughnessSteps;
    const float now = missing[static_cast<std::size_t>(std::clamp(
                                  std::lround(entry), 0l, static_cast<long>(missing.size()) - 1))]
                          .w;
    foam_crest_[layer] = now - before;
    before = now;
  }
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

double Ocean::streaks() const { return std::clamp((wind_speed_ - 13.0) / 13.0, 0.0, 1.0); }

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
  // Ripples are the finest cascade's waves at a smaller scale; their crests would be too slow by
  // its root.
  const std::size_t finest = cascades_.size() - 1;
  constexpr double kFaster = 0.3;  // m/s
  const double drift = kFaster * view.time;
  const glm::dvec2 at = (view.eye - drift * wind_to_) / static_cast<double>(shared::kRippleScale);
  const CascadeBand& band = cascades_[finest].band;
  const double x = std::cos(band.angle) / band.length, z = std::sin(band.angle) / band.length;
  data.origin[finest].z = static_cast<float>(fraction(x * at.x + z * at.y));
  data.origin[finest].w = static_cast<float>(fraction(x * at.y - z * at.x));
  data.grid[finest].w = static_cast<float>(std::sqrt(ripples_));
  data.water = glm::vec4(glm::dvec4(statistics_.hs, settings_.cascades,
                                    SeaMesh::kReach * settings_.mesh_cells, mesh_.finest_spacing));

  data.foam = glm::vec4(glm::dvec4(foam_law_.birth, foam_law_.present, breaking_cascades(cascades_),
                                   foam_law_.softness));
  data.foam_share =
      glm::vec4(glm::dvec4(white_share_, std::max(white_share_ / foam_law_.breaking, 1.0),
                           foam_law_.variance, streaks()));
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
  data.foam_stretch = glm::vec4(glm::dvec4(stretch, stretch * 256.0, foam_crest_[0], 0));
  data.foam_crest = glm::vec4(foam_crest_[1], foam_crest_[2], foam_crest_[3], foam_crest_[4]);

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
  data.plume = rgb(glm::exp(-1.2 * extinction));
  const glm::dvec3 loss = body.absorption + glsl::kScatteringLost * body.scattering;
  data.crest_loss = rgb(loss, body.scattering.y);
  data.crest_gain = rgb(0.5 / (glsl::kWaterIndex * glsl::kWaterIndex) * body.scattering / loss);
  data.hull_loss = rgb(body.absorption + 12.0 * body.backscatter);
  block_.write(data);
}

}  // namespace offing
