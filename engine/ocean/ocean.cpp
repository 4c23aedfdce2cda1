#include "engine/ocean/ocean.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/angles.h"
#include "engine/ocean/crossfade.h"
#include "engine/ocean/fft_moments.h"
#include "engine/ocean/foam_pattern.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/ocean.h"

namespace offing {
namespace {

constexpr double kAtOnce = std::numeric_limits<double>::infinity();
constexpr std::size_t kMaxSquares = 8192;
constexpr double kFoamLength = 7.3;  // m across the wind; no multiple of a cascade's length
constexpr int kFoamTexels = 256;
constexpr double kFoamSoftness = 0.15;  // variance of the edge of foam over that of the Jacobian

/// x with normal_below(x) = share.
double normal_quantile(double share) {
  double low = -8.0, high = 8.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (0.5 * std::erfc(-middle / std::sqrt(2.0)) < share ? low : high) = middle;
  }
  return low;
}

/// Bands of ripples do not break; with them the foam would be dots.
double breaks(const CascadeBand& band) {
  constexpr double kLongestRipple = 5.0;  // m
  return band.k_min < kTau / kLongestRipple ? 1.0 : 0.0;
}

double fraction(double x) { return x - std::floor(x); }

glm::vec4 to_vec4(const SlopeVariance& v) {
  return glm::vec4(glm::dvec4(v.xx, v.zz, v.xz, v.total()));
}

}  // namespace

OceanSettings OceanSettings::of_quality(int quality) {
  OceanSettings settings;
  settings.size = quality <= 0 ? 128 : 256;
  settings.mesh_cells = quality <= 0 ? 8 : quality == 1 ? 14 : quality == 2 ? 22 : 32;
  settings.cascades = quality >= 3 ? 4 : 3;
  return settings;
}

Ocean::Ocean(ShaderLibrary& shaders, const OceanSettings& settings)
    : settings_(settings),
      shaders_(shaders),
      maps_(shaders, settings.cascades, settings.size),
      water_(std::make_unique<FftMoments>()),
      mesh_{.cells = settings.mesh_cells, .finest_spacing = 3.2 / settings.mesh_cells},
      mesh_program_(
          shaders.program({"ocean/mesh.vert", "ocean/mesh.frag"},
                          {{"MORPH", std::to_string(SeaMesh::kMorph)},
                           {"FOOTPRINT_RATIO", settings.mesh_cells <= 8 ? "3.0" : "4.0"}})),
      surface_(shaders.program({"post/full_screen.vert", "ocean/surface.frag"})),
      squares_("sea.squares", kMaxSquares * sizeof(SeaMesh::Square)),
      block_("sea.block", sizeof(shared::OceanData)),
      array_("sea.mesh"),
      no_vertices_("sea.picture"),
      map_sampler_("sea.map", GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_REPEAT, GL_REPEAT),
      foam_sampler_("sea.foam", GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_REPEAT, GL_REPEAT),
      foam_(make_foam_pattern(kFoamTexels)) {
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
}

void Ocean::prime(FrameGraph& graph, double time) {
  constexpr int kMostFrames = 16;
  for (int frame = 0; frame < kMostFrames && water_.age(time) > 0.0; ++frame) {
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
  double carried = 0.0;
  for (std::size_t c = 0; c < cascades_.size(); ++c) {
    const Cascade& cascade = cascades_[c];
    const double x = std::cos(cascade.band.angle) / cascade.band.length;
    const double z = std::sin(cascade.band.angle) / cascade.band.length;
    const double point = cascade.band.length / cascade.size;
    data.grid[c] = glm::vec4(glm::dvec4(x, z, std::log2(point), breaks(cascade.band)));
    // Map points lie at whole indices: shift by half a texel. Whole periods are dropped in double.
    const double half = 0.5 / cascade.size;
    data.origin[c] = glm::vec4(glm::dvec4(fraction(x * view.eye.x + z * view.eye.y + half),
                                          fraction(x * view.eye.y - z * view.eye.x + half), 0, 0));
    for (int level = 0; level < shared::kOceanMapLevels; ++level) {
      data.resolved[c * shared::kOceanMapLevels + static_cast<std::size_t>(level)] =
          to_vec4(cascade.resolved[level]);
    }
    carried += cascade.resolved[0].total();
  }
  data.variance = to_vec4(slope_variance_);
  // The Jacobian is 1 + Dxx + Dzz to first order: normal with variance c^2 <|slope|^2>.
  const double deviation = choppiness_ * std::sqrt(carried);
  const double quantile = normal_quantile(std::clamp(white_share_, 1e-9, 0.5));
  // Softening the edge by a share of that variance widens the whole distribution; so it is allowed
  // for.
  const double soft = kFoamSoftness * deviation * deviation;
  data.foam =
      glm::vec4(glm::dvec4(std::min(1.0 + quantile * std::sqrt(deviation * deviation + soft), 0.9),
                           choppiness_ * choppiness_, carried, soft + 1e-4));
  // Wind draws foam out into streaks.
  const double stretch = 1.0 + wind_speed_ / 8.0;
  const glm::dvec2 along = wind_to_ / (kFoamLength * stretch);
  const double u = glm::dot(along, view.eye);
  const double v = stretch * (along.x * view.eye.y - along.y * view.eye.x);
  data.foam_grid = glm::vec4(glm::dvec4(fraction(u), fraction(v), along.x, along.y));
  data.foam_stretch = glm::vec4(glm::dvec4(stretch, stretch * kFoamTexels, 0, 0));
  data.water = glm::vec4(glm::dvec4(statistics_.hs, settings_.cascades,
                                    SeaMesh::kReach * settings_.mesh_cells, mesh_.finest_spacing));
  block_.write(data);
}

void Ocean::add_draw(FrameGraph& graph, const OceanView& view, const SeaIds& sea,
                     const LightAccess& sky, TextureId dry, TextureId hdr, TextureId depth,
                     bool visible) {
  std::vector<SeaMesh::Square> squares;
  if (visible) {
    squares = mesh_.select(view.eye, view.eye_height, 1.2 * statistics_.hs + 0.1,
                           view.clip_from_relative);
    if (squares.size() > kMaxSquares) squares.resize(kMaxSquares);
  }
  const bool nothing_in_view = squares.empty();
  gl::TextureDesc seen_desc = graph.desc(hdr);
  seen_desc.format = GL_RGBA32F;
  const TextureId seen = graph.create("sea.seen", seen_desc);

  graph.add(
      "sea.mesh",
      [&](PassBuilder& pass) {
        pass.read(sea.displacement).read(dry);
        pass.write(seen, Access::kAttachment).modify(depth).render_to({seen}, depth);
        pass.skip_if(nothing_in_view);
      },
      [this, view, sea, dry, squares = std::move(squares)](const PassContext& context) {
        update_block(view);
        squares_.write(squares.data(), squares.size() * sizeof(SeaMesh::Square));
        const float nowhere[4] = {0.0f, 0.0f, 0.0f, 0.0f};
        glClearBufferfv(GL_COLOR, 0, nowhere);
        context.texture(sea.displacement).bind(0);
        context.texture(dry).bind(3);
        map_sampler_.bind(0);
        block_.bind_uniform(OFFING_BIND_OCEAN);
        mesh_program_.use();
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

  graph.add(
      "sea.draw",
      [&](PassBuilder& pass) {
        pass.read(sea.displacement).read(sea.slopes).read(seen);
        sky.declare(pass);
        pass.modify(hdr).render_to({hdr});
        pass.skip_if(nothing_in_view);
      },
      [this, sea, seen, bind_sky = sky.bind](const PassContext& context) {
        context.texture(sea.displacement).bind(0);
        context.texture(sea.slopes).bind(1);
        foam_.bind(2);
        context.texture(seen).bind(3);
        map_sampler_.bind(0);
        map_sampler_.bind(1);
        foam_sampler_.bind(2);
        block_.bind_uniform(OFFING_BIND_OCEAN);
        bind_sky(context);
        surface_.use();
        glDisable(GL_DEPTH_TEST);
        glDisable(GL_BLEND);
        no_vertices_.bind();
        glDrawArrays(GL_TRIANGLES, 0, 3);
        for (const GLuint unit : {0u, 1u, 2u}) glBindSampler(unit, 0);
      });
}

}  // namespace offing
