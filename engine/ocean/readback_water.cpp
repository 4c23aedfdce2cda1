#include "engine/ocean/readback_water.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "engine/ocean/surface_point.h"

namespace offing {
namespace {

constexpr double kNever = std::numeric_limits<double>::quiet_NaN();
constexpr double kTolerance = 0.002;  // m, of the place that a query meets
constexpr int kSteps = 8;
constexpr double kLongestStep = 0.5;    // s between results that still give a velocity

/// Catmull-Rom weights of four neighbours, and their derivatives, at 0 <= t < 1 between the middle
/// two: errors of third order where linear weights leave second.
struct Weights {
  double value[4], slope[4];
  explicit Weights(double t) {
    const double t2 = t * t, t3 = t2 * t;
    value[0] = 0.5 * (-t + 2.0 * t2 - t3);
    value[1] = 0.5 * (2.0 - 5.0 * t2 + 3.0 * t3);
    value[2] = 0.5 * (t + 4.0 * t2 - 3.0 * t3);
    value[3] = 0.5 * (t3 - t2);
    slope[0] = 0.5 * (-1.0 + 4.0 * t - 3.0 * t2);
    slope[1] = 0.5 * (-10.0 * t + 9.0 * t2);
    slope[2] = 0.5 * (1.0 + 8.0 * t - 9.0 * t2);
    slope[3] = 0.5 * (3.0 * t2 - 2.0 * t);
  }
};

}  // namespace

ReadbackWater::ReadbackWater(int cascades, int size)
    : cascades_(cascades), size_(size), asked_(kNever) {}

void ReadbackWater::set_waves(std::span<const Cascade> cascades) {
  grids_.clear();
  for (int c = 0; c < cascades_; ++c) {
    const CascadeBand& band = cascades[static_cast<std::size_t>(c)].band;
    grids_.push_back({std::cos(band.angle) / band.length, std::sin(band.angle) / band.length});
  }
  const auto points = static_cast<std::size_t>(cascades_ * size_ * size_);
  ring_ = std::make_unique<gl::ReadbackRing>("sea.readback", points * 4 * sizeof(float));
  asked_ = kNever;
  fresh_waves_ = true;
}

void ReadbackWater::add_copy(FrameGraph& graph, const SeaIds& sea, double time) {
  graph.add(
      "sea.readback",
      [&](PassBuilder& pass) {
        pass.read(sea.displacement, Access::kTransfer).side_effect().skip_if(time == asked_);
      },
      [this, sea, time](const PassContext& context) {
        const GLuint target = ring_->begin();
        if (target == 0) return;  // all are on their way: this moment is left out
        glBindBuffer(GL_PIXEL_PACK_BUFFER, target);
        glPixelStorei(GL_PACK_ALIGNMENT, 4);
        const auto points = static_cast<std::size_t>(cascades_ * size_ * size_);
        glGetTextureSubImage(context.texture(sea.displacement).id(), 0, 0, 0, 0, size_, size_,
                             cascades_, GL_RGBA, GL_FLOAT,
                             static_cast<GLsizei>(points * 4 * sizeof(float)), nullptr);
        glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
        ring_->issue(time);
        asked_ = time;
      });
}

void ReadbackWater::collect() {
  gl::ReadbackRing::Result result{};
  if (ring_ == nullptr || !ring_->poll(&result)) return;
  auto moment = std::make_shared<Moment>();
  moment->time = result.tag;
  moment->maps.resize(result.bytes.size() / sizeof(float));
  std::memcpy(moment->maps.data(), result.bytes.data(), result.bytes.size());
  auto next = std::make_shared<Snapshot>(Snapshot{grids_, size_, std::move(moment), nullptr});
  if (const auto now = snapshot(); now != nullptr && !fresh_waves_) {
    const auto& last = now->newest->time != next->newest->time ? now->newest : now->before;
    if (last != nullptr && std::abs(next->newest->time - last->time) <= kLongestStep) {
      next->before = last;
    }
  }
  fresh_waves_ = false;
  const std::lock_guard lock(mutex_);
  snapshot_ = std::move(next);
}

std::shared_ptr<const ReadbackWater::Snapshot> ReadbackWater::snapshot() const {
  const std::lock_guard lock(mutex_);
  return snapshot_;
}

double ReadbackWater::newest_time() const {
  const auto now = snapshot();
  return now == nullptr ? kNever : now->newest->time;
}

double ReadbackWater::age(double time) const {
  const auto now = snapshot();
  return now == nullptr ? std::numeric_limits<double>::infinity()
                        : std::abs(time - now->newest->time);
}

void ReadbackWater::sample(std::span<const glm::dvec2> points, double time,
                           std::span<WaterSample> out) const {
  const auto now = snapshot();
  if (now == nullptr) {
    std::fill(out.begin(), out.end(), WaterSample{});
    return;
  }
  const Moment& newest = *now->newest;
  const Moment* before = now->before.get();
  const double step = before == nullptr ? 0.0 : newest.time - before->time;
  const double reach = std::clamp(time - newest.time, -kLongestReach, kLongestReach);
  const double left = share_left(std::abs(time - newest.time));
  const double ahead = before == nullptr ? 0.0 : reach / step;
  const int size = now->size, mask = size - 1;

  // All cascades at a parameter point: displacement at the asked time with its derivatives, and the
  // difference between the two results.
  glm::dvec3 change{0.0};
  const auto surface = [&](glm::dvec2 q) {
    SurfacePoint p;
    change = glm::dvec3(0.0);
    for (std::size_t c = 0; c < now->grids.size(); ++c) {
      const Grid& grid = now->grids[c];
      const double u = (grid.x * q.x + grid.z * q.y) * size,
                   v = (grid.x * q.y - grid.z * q.x) * size;
      const double fu = std::floor(u), fv = std::floor(v);
      const Weights wu(u - fu), wv(v - fv);
      const auto iu = static_cast<std::int64_t>(fu), iv = static_cast<std::int64_t>(fv);
      glm::dvec3 value{0.0}, du{0.0}, dv{0.0};
      for (int j = 0; j < 4; ++j) {
        const auto row =
            c * static_cast<std::size_t>(size) + static_cast<std::size_t>((iv + j - 1) & mask);
        for (int i = 0; i < 4; ++i) {
          const std::size_t at = 4 * (row * static_cast<std::size_t>(size) +
                                      static_cast<std::size_t>((iu + i - 1) & mask));
          glm::dvec3 d{newest.maps[at], newest.maps[at + 1], newest.maps[at + 2]};
          if (before != nullptr) {
            const glm::dvec3 moved =
                d - glm::dvec3(before->maps[at], before->maps[at + 1], before->maps[at + 2]);
            change += wu.value[i] * wv.value[j] * moved;
            d += ahead * moved;
          }
          value += wu.value[i] * wv.value[j] * d;
          du += wu.slope[i] * wv.value[j] * d;
          dv += wu.value[i] * wv.slope[j] * d;
        }
      }
      p.displacement += value;
      const glm::dvec3 dx = (du * grid.x - dv * grid.z) * static_cast<double>(size);
      const glm::dvec3 dz = (du * grid.z + dv * grid.x) * static_cast<double>(size);
      p.slope += glm::dvec2(dx.y, dz.y);
      p.dxx += dx.x;
      p.dzz += dz.z;
      p.dxz += 0.5 * (dx.z + dz.x);
    }
    p.displacement *= left;
    p.slope *= left;
    p.dxx *= left;
    p.dzz *= left;
    p.dxz *= left;
    return p;
  };

  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec2 q = parameter_at(points[i], kTolerance, kSteps, surface);
    const SurfacePoint p = surface(q);
    out[i].height = p.displacement.y;
    out[i].normal = surface_normal(p);
    out[i].velocity = before == nullptr ? glm::dvec3(0.0) : left * change / step;
  }
}

}  // namespace offing
