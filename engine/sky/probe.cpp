#include "engine/sky/probe.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/core/angles.h"
#include "engine/core/random.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/probe.h"

#define OFFING_GLSL "shaders/lib/probe.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

using shared::kProbeLevels;

constexpr int kListWidth = 1024;  // texels, of four nodes each
// A leap: the light has gone further in one frame than any clock of the game moves it, or the
// camera is elsewhere. What is shown is then made anew at once.
constexpr double kLeapAngle = 0.026, kLeapHaze = 0.02, kLeapHeight = 0.25;
// Steps that start another generation.
constexpr double kAngleStep = 1e-4, kHeightStep = 0.02, kLightStep = 1e-3, kWindStep = 0.25;
// How far sun and moon may go while a generation is made, and the fewest frames it is spread over.
// What is shown is brought in by turns of a part of its tiles, so that frames come in such numbers.
constexpr double kWayOfGeneration = radians(5.0);
constexpr int kFewestFrames = 8, kParts = 4;

// Texels per side of a level over those of level 0, in 48ths.
constexpr int kSides[kProbeLevels] = {48, 40, 40, 38, 28, 22, 17, 13, 10, 8, 7, 6, 5};

// Nanoseconds per texel or node, and per pair of texel and node, on a CPU renderer; only their
// ratios matter.
constexpr double kCaptureCost = 400.0, kMipCost = 60.0, kPairCost = 1.0, kIrradianceCost = 60.0,
                 kSharpenCost = 100.0;

std::vector<int> sides_of(int size) {
  std::vector<int> sides;
  for (const int share : kSides) sides.push_back(share * size / 48);
  return sides;
}

std::int64_t steps_of(double value, double step) {
  return static_cast<std::int64_t>(std::llround(value / step));
}

std::uint64_t hash_direction(const glm::dvec3& d, double step) {
  return hash_of(steps_of(d.x, step), steps_of(d.y, step), steps_of(d.z, step));
}

}  // namespace

ProbeSettings ProbeSettings::of_quality(int quality) {
  constexpr ProbeSettings kQualities[] = {{192, 64}, {192, 64}, {256, 24}, {256, 24}};
  return kQualities[std::clamp(quality, 0, 3)];
}

void ProbeIds::read_by(PassBuilder& pass) const { pass.read(map).read(block, Access::kUniform); }

/// One frame's part.
struct Probe::Frame {
  int index = 0, of = 1;  ///< of the frames over which the generation is spread
  bool builds = false, blends = false;
  bool leap = false;  ///< all of a generation, shown at once
  std::uint64_t key = 0;
  State state{};
  const Sky* sky = nullptr;
  SkyIds sky_ids{};
  std::optional<ProbeClouds> clouds;
  bool idle() const { return !builds && !blends; }
};

Probe::Probe(ShaderLibrary& shaders, const ProbeSettings& settings)
    : settings_(settings),
      capture_(shaders.program({"sky/probe_capture.comp"})),
      mip_(shaders.program({"sky/probe_mip.comp"})),
      level_(shaders.program({"sky/probe_level.comp"})),
      sharpen_(shaders.program({"sky/probe_sharpen.comp"})),
      irradiance_(shaders.program({"sky/probe_irradiance.comp"})),
      blend_(shaders.program({"sky/probe_blend.comp"})),
      plan_(settings.size, sides_of(settings.size)),
      linear_("probe", GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE),
      nearest_("probe nodes", GL_NEAREST, GL_NEAREST, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE) {
  shared::ProbeData data{};
  int rows = 0;
  for (int level = 0; const int side : sides_of(settings_.size)) {
    const double alpha = level > 0 ? glsl::probe_alpha(level) : 0.0;
    data.levels[level++] = glm::vec4(0.0f, rows, side, alpha);
    rows += side;
  }
  const gl::TextureDesc desc{.format = GL_RGBA16F, .width = 2 * settings_.size, .height = rows};
  shown_ = gl::Texture("probe shown", desc);
  for (Generation& generation : generations_) {
    generation.map = gl::Texture("probe generation", desc);
    generation.irradiance =
        gl::Buffer("probe irradiance", shared::kProbeHarmonics * sizeof(glm::vec4));
  }
  const gl::TextureDesc nodes{
      .format = GL_RGBA32F, .width = 2 * settings_.size, .height = 2 * settings_.size};
  sums_ = gl::Texture("probe sums", desc);
  // Between levels there are texels that are filtered with a weight of zero, and never written.
  for (const gl::Texture* map : {&shown_, &sums_}) {
    glClearTexImage(map->id(), 0, GL_RGBA, GL_FLOAT, nullptr);
  }
  seen_ = gl::Texture("probe seen", nodes);
  glClearTexImage(seen_.id(), 0, GL_RGBA, GL_FLOAT, nullptr);
  places_ = gl::Texture("probe places", nodes);
  places_.upload(GL_RGBA, GL_FLOAT, plan_.places.data());
  const auto lists = static_cast<int>(plan_.lists.size() / 4);
  const int list_rows = (lists + kListWidth - 1) / kListWidth;
  plan_.lists.resize(static_cast<std::size_t>(4 * kListWidth * list_rows));
  lists_ =
      gl::Texture("probe lists", {.format = GL_RGBA32UI, .width = kListWidth, .height = list_rows});
  lists_.upload(GL_RGBA_INTEGER, GL_UNSIGNED_INT, plan_.lists.data());
  tiles_ = gl::Buffer::of<glm::uvec4>("probe tiles", plan_.tiles);
  plan_.places.clear();
  plan_.lists.clear();
  data.texel = glm::vec4(1.0f / static_cast<float>(desc.width),
                         1.0f / static_cast<float>(desc.height), 0.0f, 0.0f);
  block_ = gl::Buffer("probe block", sizeof(data), GL_DYNAMIC_STORAGE_BIT, &data);
  plan_work();
}

void Probe::plan_work() {
  const double texels = settings_.size * settings_.size, tile = ProbePlan::kTile * ProbePlan::kTile;
  const int all = static_cast<int>(plan_.tiles.size());
  const auto tiles = [&](Kind kind, int first, int last, const auto& cost) {
    for (int i = first; i < last; ++i) work_.push_back({kind, i, 1, cost(i), 0});
  };
  tiles(Kind::kCapture, 0, plan_.first_sum, [&](int) { return kCaptureCost * tile; });
  work_.push_back({Kind::kMips, 0, 0, kMipCost * 2.0 / 3.0 * texels, 0});
  work_.push_back({Kind::kIrradiance, 0, 0, kIrradianceCost * texels / 8.0, 0});
  tiles(Kind::kLevel, plan_.first_sum, all,
        [&](int i) { return kPairCost * tile * 4.0 * plan_.tiles[static_cast<std::size_t>(i)].y; });
  tiles(Kind::kSharpen, plan_.first_sum, all, [&](int) { return kSharpenCost * tile; });
  double total = 0.0, done = 0.0;
  for (const Work& work : work_) total += work.cost;
  for (Work& work : work_) {
    const double middle = (done + 0.5 * work.cost) / total;
    work.slice = std::min(static_cast<int>(middle * settings_.slices), settings_.slices - 1);
    done += work.cost;
  }
  // One entry for all of a kind in a slice.
  std::vector<Work> merged;
  for (const Work& work : work_) {
    if (!merged.empty() && merged.back().slice == work.slice && merged.back().kind == work.kind) {
      merged.back().tiles += work.tiles;
      merged.back().cost += work.cost;
    } else {
      merged.push_back(work);
    }
  }
  work_ = std::move(merged);
}

std::vector<double> Probe::slice_shares() const {
  std::vector<double> shares(static_cast<std::size_t>(settings_.slices), 0.0);
  double total = 0.0;
  for (const Work& work : work_) {
    shares[static_cast<std::size_t>(work.slice)] += work.cost;
    total += work.cost;
  }
  for (double& share : shares) share /= total;
  return shares;
}

ProbeIds Probe::add(FrameGraph& graph, const SkyLight& light, double wind_speed, const Sky& sky,
                    const SkyIds& sky_ids, const std::optional<ProbeClouds>& clouds, bool on) {
  Frame frame;
  frame.state = {light.sun_direction, light.moon_direction, std::max(light.camera_height, 1.0),
                 light.haze,          clouds.has_value(),   on};
  const bool moon_counts = light.sun_direction.y < 0.05 && light.moon_direction.y > -0.05;
  frame.key =
      hash_of(hash_direction(light.sun_direction, kAngleStep),
              moon_counts ? hash_direction(light.moon_direction, kAngleStep) : std::uint64_t{0},
              steps_of(light.sun_uncovered, kLightStep), steps_of(light.moon_phase, kLightStep),
              steps_of(std::log(frame.state.height + 10.0), kHeightStep), light.haze,
              static_cast<int>(light.painted.mode), light.painted.strength,
              hash_direction(light.painted.zenith / (1e-9 + light.painted.zenith.y), kLightStep),
              hash_direction(light.painted.horizon / (1e-9 + light.painted.zenith.y), kLightStep),
              steps_of(wind_speed, kWindStep), on, clouds ? clouds->version + 1 : std::uint64_t{0},
              capture_.generation() + mip_.generation() + level_.generation() +
                  sharpen_.generation() + irradiance_.generation());
  const auto angle = [](const glm::dvec3& a, const glm::dvec3& b) {
    return glm::length(glm::cross(a, b)) + (glm::dot(a, b) < 0.0 ? 1.0 : 0.0);
  };
  frame.leap =
      !complete_ || angle(frame.state.sun, last_.sun) > kLeapAngle ||
      (moon_counts && angle(frame.state.moon, last_.moon) > kLeapAngle) ||
      std::abs(frame.state.haze - last_.haze) > kLeapHaze ||
      std::abs(std::log((frame.state.height + 100.0) / (last_.height + 100.0))) > kLeapHeight ||
      frame.state.clouds != last_.clouds || frame.state.on != last_.on;
  frame.blends = frame.leap || blend_left_ > 0;
  if (!frame.leap && frame_ < frames_) {
    frame.builds = true;
    frame.index = frame_;
    frame.of = frames_;
  } else if (frame.leap || frame.key != key_) {
    frame.builds = true;
    const double pace = std::max(angle(frame.state.sun, last_.sun),
                                 moon_counts ? angle(frame.state.moon, last_.moon) : 0.0);
    const double most = kWayOfGeneration / std::max(pace, 1e-9);  // frames
    const int frames = static_cast<int>(std::min(most, 1.0 * settings_.slices)) / kParts * kParts;
    frame.of = frame.leap ? 1 : std::max(frames, kFewestFrames);
  }
  frame.sky = &sky;
  frame.sky_ids = sky_ids;
  frame.clouds = clouds;

  const ProbeIds ids{graph.import(shown_), graph.import(block_)};
  graph.add(
      "sky.probe",
      [&](PassBuilder& pass) {
        pass.write(ids.map).write(ids.block).cached_if(frame.idle());
        if (frame.idle()) return;
        sky_ids.read_by(pass);
        if (clouds) pass.read(clouds->map);
        // The generations are the probe's own: run_slices() and blend() order what touches them.
      },
      [this, frame](const PassContext& context) { run(frame, context); });
  return ids;
}

void Probe::run(const Frame& frame, const PassContext& context) {
  frame.sky->bind(context, frame.sky_ids);
  if (frame.clouds) {
    context.texture(frame.clouds->map).bind(OFFING_UNIT_CLOUD_MAP);
    linear_.bind(OFFING_UNIT_CLOUD_MAP);
  }
  linear_.bind(OFFING_UNIT_PROBE);
  // The map of an earlier frame goes on being shown while the next one is made.
  if (frame.blends && !frame.leap) blend(blend_left_--);
  if (frame.builds) {
    if (frame.index == 0) key_ = frame.key;
    frames_ = frame.of;
    frame_ = frame.index + 1;
    const int first = frame.index * settings_.slices / frames_;
    const int last = frame_ * settings_.slices / frames_;
    run_slices(frame, first, last, generations_[building_]);
    if (frame_ == frames_) {
      building_ = 1 - building_;
      blend_left_ = frames_shown_ = frames_;
      complete_ = true;
    }
  }
  if (frame.leap) blend(blend_left_ = 0);
  last_ = frame.state;
}

void Probe::run_slices(const Frame& frame, int first, int last, const Generation& into) {
  int unit = 0;
  for (const gl::Texture* texture : {&places_, &seen_, &lists_}) {
    texture->bind(static_cast<GLuint>(unit));
    nearest_.bind(static_cast<GLuint>(unit++));
  }
  sums_.bind(3);
  linear_.bind(3);
  seen_.bind_image(1, GL_READ_WRITE);
  block_.bind_uniform(OFFING_BIND_PROBE);
  into.irradiance.bind_storage(0);
  tiles_.bind_storage(1);
  on_ = frame.state.on;
  for (std::size_t i = 0; i < work_.size(); ++i) {
    Work work = work_[i];
    if (work.slice < first || work.slice >= last) continue;
    // What is done in the same frame by the same program is one dispatch.
    for (; i + 1 < work_.size() && work_[i + 1].slice < last && work_[i + 1].kind == work.kind;
         ++i) {
      work.tiles += work_[i + 1].tiles;
    }
    // It may read what the last one wrote.
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                    GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    if (work.kind == Kind::kCapture) capture_.program().set(4, frame.clouds ? 1 : 0);
    const bool sums = on_ && work.kind == Kind::kLevel;  // still to be sharpened
    (sums ? sums_ : into.map).bind_image(0, GL_WRITE_ONLY);
    dispatch(work);
  }
}

void Probe::dispatch(const Work& work) const {
  const auto make_tiles = [&](const ShaderProgram& program) {
    program.use();
    program.program().set(0, work.first_tile);
    glDispatchCompute(static_cast<GLuint>(work.tiles), 1, 1);
  };
  switch (work.kind) {
    case Kind::kLevel:
      if (on_) {
        make_tiles(level_);
        break;
      }
      [[fallthrough]];  // every level shows the sky's tables
    case Kind::kCapture:
      capture_.program().set(5, on_ ? 0 : 1);
      make_tiles(capture_);
      break;
    case Kind::kMips:
      make_mips();
      break;
    case Kind::kSharpen:
      if (on_) make_tiles(sharpen_);
      break;
    case Kind::kIrradiance: {
      constexpr int kMip = 2;  // fine enough for what it keeps
      const int size = settings_.size;
      irradiance_.use();
      irradiance_.program().set(5, on_ ? 0 : 1);
      irradiance_.program().set(
          0, glm::ivec4(ProbePlan::first_row(size, kMip), 2 * size >> kMip, size >> kMip, 0));
      glDispatchCompute(1, 1, 1);
      break;
    }
  }
}

void Probe::make_mips() const {
  const int size = settings_.size;
  mip_.use();
  for (int mip = 1; mip < ProbePlan::kMips; ++mip) {
    const int side = size >> mip;
    mip_.program().set(0, glm::ivec4(ProbePlan::first_row(size, mip - 1),
                                     ProbePlan::first_row(size, mip), 2 * side, side));
    glDispatchCompute(static_cast<GLuint>((2 * side + 7) / 8), static_cast<GLuint>((side + 7) / 8),
                      1);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  }
}

void Probe::blend(int left) {
  const Generation& whole = generations_[1 - building_];
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
  shown_.bind_image(0, GL_READ_WRITE);
  whole.map.bind_image(1, GL_READ_ONLY);
  block_.bind_storage(0);
  whole.irradiance.bind_storage(2);
  tiles_.bind_storage(1);
  block_.bind_uniform(OFFING_BIND_PROBE);
  // By a slow clock each part of the tiles has its turn every kParts frames, and goes further each
  // time; by a fast one all of them in every frame.
  const int all = static_cast<int>(plan_.tiles.size());
  const int parts = left > 0 && frames_shown_ == settings_.slices ? kParts : 1;
  const int part = (parts - left % parts) % parts;
  const int first = part * all / parts, last = (part + 1) * all / parts;
  const int turns = std::max((left + parts - 1) / parts, 1);
  blend_.use();
  blend_.program().set(0, first);
  blend_.program().set(
      1, glm::vec2(1.0f / static_cast<float>(turns), 1.0f / static_cast<float>(std::max(left, 1))));
  glDispatchCompute(static_cast<GLuint>(last - first), 1, 1);
}

void Probe::bind(const PassContext& context, const ProbeIds& ids) const {
  context.texture(ids.map).bind(OFFING_UNIT_PROBE);
  linear_.bind(OFFING_UNIT_PROBE);
  context.buffer(ids.block).bind_uniform(OFFING_BIND_PROBE);
}

}  // namespace offing
