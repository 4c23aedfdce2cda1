#include "engine/ocean/sea_water.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/ocean/crossfade.h"
#include "engine/ocean/surface_point.h"

namespace offing {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();
// m, of the place that a query meets: the rest is corrected along the surface's tangent, which
// leaves a tenth of a millimetre on the sharpest crests.
constexpr double kTolerance = 0.01;
constexpr int kSteps = 8;

// Four floats that the compiler keeps in one register (GCC and Clang).
using Float4 = float __attribute__((vector_size(16)));

Float4 load(const float* p) { return Float4{p[0], p[1], p[2], p[3]}; }
glm::dvec3 to_dvec3(Float4 v) { return {v[0], v[1], v[2]}; }

/// Cubic B-spline weights of four neighbours and their derivatives at 0 <= t < 1 between the middle
/// two.
struct Weights {
  float value[4], slope[4];
  explicit Weights(float t) {
    const float u = 1.0f - t, t2 = t * t, u2 = u * u;
    value[0] = u * u2 / 6.0f;
    value[1] = 2.0f / 3.0f - t2 + 0.5f * t2 * t;
    value[2] = 2.0f / 3.0f - u2 + 0.5f * u2 * u;
    value[3] = t * t2 / 6.0f;
    slope[0] = -0.5f * u2;
    slope[1] = -2.0f * t + 1.5f * t2;
    slope[2] = 2.0f * u - 1.5f * u2;
    slope[3] = 0.5f * t2;
  }
};

/// What values and rates before and after count at a time between them.
struct TimeWeights {
  float before, before_rate, after, after_rate;
};

// Hermite's cubic, and its derivative.
TimeWeights cubic(double part, double step) {
  const double p2 = part * part, p3 = p2 * part;
  return {static_cast<float>(1.0 - 3.0 * p2 + 2.0 * p3),
          static_cast<float>((part - 2.0 * p2 + p3) * step),
          static_cast<float>(3.0 * p2 - 2.0 * p3), static_cast<float>((p3 - p2) * step)};
}
TimeWeights cubic_rate(double part, double step) {
  const double p2 = part * part;
  return {static_cast<float>(6.0 * (p2 - part) / step),
          static_cast<float>(1.0 - 4.0 * part + 3.0 * p2),
          static_cast<float>(6.0 * (part - p2) / step), static_cast<float>(3.0 * p2 - 2.0 * part)};
}

struct Patch {
  glm::dvec3 value{0.0}, dx{0.0}, dz{0.0};
};

}  // namespace

bool same_grid(const Cascade& a, const Cascade& b) {
  return a.size == b.size && a.band.length == b.band.length && a.band.angle == b.band.angle &&
         a.frequency == b.frequency;
}

/// One cascade of one sea at the time of a query.
struct SeaWater::Layer {
  MomentPair moments;
  std::size_t first;  // of this cascade's floats
  int size;
  double x, z;  // (cos, sin)(angle) / length
  TimeWeights value, rate;
  double share, share_rate;  // of this cascade in what is seen
  double choppiness, choppiness_rate;

  /// Values (Dx, h, Dz at choppiness 1) by `weights` in time, with derivatives in space.
  Patch at(glm::dvec2 q, const TimeWeights& weights) const {
    const double pu = x * q.x + z * q.y, pv = x * q.y - z * q.x;  // in patches
    const double u = (pu - std::floor(pu)) * size, v = (pv - std::floor(pv)) * size;
    const double fu = std::floor(u), fv = std::floor(v);
    const Weights wu(static_cast<float>(u - fu)), wv(static_cast<float>(v - fv));
    const auto iu = static_cast<std::int64_t>(fu), iv = static_cast<std::int64_t>(fv);
    const std::int64_t mask = size - 1;
    const float* before = moments.before->values.data() + first;
    const float* after = moments.after->values.data() + first;
    std::size_t column[4];
    for (int i = 0; i < 4; ++i) {
      column[i] = WaveMoment::kFloats * static_cast<std::size_t>((iu + i - 1) & mask);
    }
    Float4 height{}, du{}, dv{};
    for (int j = 0; j < 4; ++j) {
      const std::size_t row = WaveMoment::kFloats * static_cast<std::size_t>(size) *
                              static_cast<std::size_t>((iv + j - 1) & mask);
      Float4 sum{}, slope{};
      for (int i = 0; i < 4; ++i) {
        const std::size_t at = row + column[i];
        const Float4 tap =
            weights.before * load(before + at) + weights.before_rate * load(before + at + 4) +
            weights.after * load(after + at) + weights.after_rate * load(after + at + 4);
        sum += wu.value[i] * tap;
        slope += wu.slope[i] * tap;
      }
      height += wv.value[j] * sum;
      du += wv.value[j] * slope;
      dv += wv.slope[j] * sum;
    }
    const glm::dvec3 gu = to_dvec3(du) * static_cast<double>(size);
    const glm::dvec3 gv = to_dvec3(dv) * static_cast<double>(size);
    return {to_dvec3(height), gu * x - gv * z, gu * z + gv * x};
  }

  void add_to(SurfacePoint& p, glm::dvec2 q) const {
    const Patch patch = at(q, value);
    const double sideways = share * choppiness;
    p.displacement += glm::dvec3(sideways, share, sideways) * patch.value;
    p.slope += share * glm::dvec2(patch.dx.y, patch.dz.y);
    p.dxx += sideways * patch.dx.x;
    p.dzz += sideways * patch.dz.z;
    p.dxz += sideways * 0.5 * (patch.dx.z + patch.dz.x);
  }

  glm::dvec3 velocity(glm::dvec2 q) const {
    const double sideways = share * choppiness;
    glm::dvec3 result = glm::dvec3(sideways, share, sideways) * at(q, rate).value;
    if (share_rate != 0.0 || choppiness_rate != 0.0) {  // while seas change
      const double turning = share_rate * choppiness + share * choppiness_rate;
      result += glm::dvec3(turning, share_rate, turning) * at(q, value).value;
    }
    return result;
  }
};

void SeaWater::set_waves(std::shared_ptr<const QueryWaves> waves, double choppiness, double begin) {
  source_->take(waves);
  auto next = std::make_shared<State>();
  next->source = source_;
  next->to = {std::move(waves), choppiness};
  if (const auto now = state(); now != nullptr && std::isfinite(begin)) {
    next->from = now->to;
    next->begin = begin;
    const auto old = now->to.waves->cascades(), fresh = next->to.waves->cascades();
    for (std::size_t c = 0; c < fresh.size(); ++c) {
      next->same_grid.push_back(offing::same_grid(old[c], fresh[c]));
    }
  }
  const std::lock_guard lock(mutex_);
  state_ = std::move(next);
}

void SeaWater::set_source(std::unique_ptr<MomentSource> source) {
  source_ = std::move(source);
  const auto now = state();
  if (now == nullptr) return;
  auto next = std::make_shared<State>(*now);
  for (const Sea* sea : {&next->from, &next->to}) {
    if (sea->waves != nullptr) source_->take(sea->waves);
  }
  next->source = source_;
  const std::lock_guard lock(mutex_);
  state_ = std::move(next);
}

std::shared_ptr<const SeaWater::State> SeaWater::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

std::vector<SeaWater::Layer> SeaWater::layers(const State& state, double time, double* age) {
  const double seconds = state.from.waves == nullptr ? kForever : time - state.begin;
  const Crossfade straight = crossfade(seconds, true);
  const double choppiness = straight.to * state.to.choppiness +
                            straight.from * (state.from.waves ? state.from.choppiness : 0.0);
  const double choppiness_rate = straight.to_rate * (state.to.choppiness - state.from.choppiness);
  std::vector<Layer> layers;
  *age = 0.0;
  for (const Sea* sea : {&state.from, &state.to}) {
    const bool fresh = sea == &state.to;
    if (sea->waves == nullptr || (fresh ? straight.to : straight.from) == 0.0) continue;
    const double at = std::floor(time / kMomentStep);
    MomentPair pair = state.source->around(sea->waves, static_cast<std::int64_t>(at));
    if (pair.before == nullptr) {
      *age = kForever;
      continue;
    }
    TimeWeights value{}, rate{};
    if (pair.after != nullptr) {
      const double part = time / kMomentStep - at;
      value = cubic(part, kMomentStep);
      rate = cubic_rate(part, kMomentStep);
    } else {  // carried on as far as that can go
      const double late = time - static_cast<double>(pair.before->index) * kMomentStep;
      const double reach = std::clamp(late, -kLongestReach, kLongestReach);
      *age = std::max(*age, std::abs(late));
      value = {1.0f, static_cast<float>(reach), 0.0f, 0.0f};
      rate = {0.0f, std::abs(late) < kLongestReach ? 1.0f : 0.0f, 0.0f, 0.0f};
      pair.after = pair.before;
    }
    const auto cascades = sea->waves->cascades();
    for (std::size_t c = 0; c < cascades.size(); ++c) {
      const Crossfade fade = crossfade(seconds, state.same_grid.empty() || state.same_grid[c]);
      const double share = fresh ? fade.to : fade.from;
      if (share == 0.0) continue;
      const CascadeBand& band = cascades[c].band;
      const std::size_t patch = pair.before->values.size() / cascades.size();
      layers.push_back({pair, c * patch, sea->waves->size(), std::cos(band.angle) / band.length,
                        std::sin(band.angle) / band.length, value, rate, share,
                        fresh ? fade.to_rate : fade.from_rate, choppiness, choppiness_rate});
    }
  }
  return layers;
}

double SeaWater::age(double time) const {
  const auto now = state();
  if (now == nullptr) return kForever;
  double age = 0.0;
  layers(*now, time, &age);
  return age;
}

void SeaWater::sample(std::span<const glm::dvec2> points, double time,
                      std::span<WaterSample> out) const {
  const auto now = state();
  double age = kForever;
  std::vector<Layer> layers;
  if (now != nullptr) layers = SeaWater::layers(*now, time, &age);
  const double left = share_left(age);
  if (left == 0.0 || layers.empty()) {
    std::fill(out.begin(), out.end(), WaterSample{});
    return;
  }
  for (Layer& layer : layers) {
    layer.share *= left;
    layer.share_rate *= left;
  }
  const auto surface = [&](glm::dvec2 q) {
    SurfacePoint p;
    for (const Layer& layer : layers) layer.add_to(p, q);
    return p;
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i].x + points[i].y)) {
      out[i] = {};
      continue;
    }
    const Meeting met = meet_surface(points[i], kTolerance, kSteps, surface);
    out[i].height = met.point.displacement.y + glm::dot(met.point.slope, met.rest);
    out[i].normal = surface_normal(met.point);
    out[i].velocity = glm::dvec3(0.0);
    for (const Layer& layer : layers) out[i].velocity += layer.velocity(met.parameter + met.rest);
  }
}

}  // namespace offing
