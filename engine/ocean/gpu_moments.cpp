#include "engine/ocean/gpu_moments.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "engine/ocean/sea_transform.h"

namespace offing {
namespace {

constexpr int kFields = 3;  // six real fields in three complex ones

std::int64_t index_at(double time) {
  return static_cast<std::int64_t>(std::floor(time / kMomentStep));
}

}  // namespace

void GpuMoments::take(const std::shared_ptr<const QueryWaves>& waves) {
  auto sea = std::make_unique<Sea>();
  const int size = waves->size(), count = static_cast<int>(waves->cascades().size());
  sea->waves = waves;
  const SeaModes modes = pack_modes(waves->cascades(), 1.0);
  sea->modes = gl::Buffer::of<float>("sea.moment modes", modes.modes);
  sea->grids = gl::Buffer::of<float>("sea.moment grids", modes.grids);
  sea->twiddles = make_twiddles(size);
  sea->work = gl::Buffer("sea.moment work", work_bytes(count, size, kFields), 0);
  const std::size_t bytes = waves->points() * WaveMoment::kFloats * sizeof(float);
  sea->out = gl::Buffer("sea.moment", bytes, 0);
  sea->ring = std::make_unique<gl::ReadbackRing>("sea.readback", bytes, 6);
  sea->columns = &shaders_.program({"ocean/columns.comp"}, transform_defines(size, kFields));
  sea->rows = &shaders_.program({"ocean/moment_rows.comp"}, transform_defines(size, kFields));
  constexpr std::size_t kMostSeas = 2;  // one that comes and one that goes
  const std::lock_guard lock(mutex_);
  if (seas_.size() >= kMostSeas) seas_.erase(seas_.begin());
  seas_.push_back(std::move(sea));
}

std::shared_ptr<const WaveMoment> GpuMoments::find(const Sea& sea, std::int64_t index) {
  for (const auto& moment : sea.known) {
    if (moment->index == index) return moment;
  }
  return nullptr;
}

MomentPair GpuMoments::around(const std::shared_ptr<const QueryWaves>& waves, std::int64_t index) {
  const std::lock_guard lock(mutex_);
  for (const auto& sea : seas_) {
    if (sea->waves != waves) continue;
    if (MomentPair pair{find(*sea, index), find(*sea, index + 1)}; pair.before && pair.after) {
      return pair;
    }
    const auto near =
        std::min_element(sea->known.begin(), sea->known.end(), [&](const auto& a, const auto& b) {
          return std::abs(2 * (a->index - index) - 1) < std::abs(2 * (b->index - index) - 1);
        });
    if (near != sea->known.end()) return {*near, nullptr};
  }
  return {};
}

void GpuMoments::add(FrameGraph& graph, double time) {
  now_ = time;
  for (const auto& owned : seas_) {
    Sea& sea = *owned;
    // The bracket of now, what is needed until a read-back from now on can have arrived, and one
    // for time that runs backwards.
    const std::int64_t first = index_at(time), last = index_at(time + kAhead) + 1;
    std::vector<std::int64_t> wanted;
    for (std::int64_t i = first; i <= last; ++i) wanted.push_back(i);
    wanted.push_back(first - 1);
    const auto missing = std::find_if(wanted.begin(), wanted.end(), [&](std::int64_t i) {
      return find(sea, i) == nullptr && std::find(sea.on_their_way.begin(), sea.on_their_way.end(),
                                                  i) == sea.on_their_way.end();
    });
    const bool none = missing == wanted.end();
    const std::int64_t index = none ? 0 : *missing;
    const BufferId out = graph.import(sea.out);
    graph.add(
        "sea.moment", [&](PassBuilder& pass) { pass.write(out).skip_if(none); },
        [this, &sea, index](PassContext&) { compute(sea, index); });
    graph.add(
        "sea.readback",
        [&](PassBuilder& pass) { pass.read(out, Access::kTransfer).side_effect().skip_if(none); },
        [&sea, index](PassContext&) {
          const GLuint target = sea.ring->begin();
          if (target == 0) return;  // all are on their way: asked again in a later frame
          glCopyNamedBufferSubData(sea.out.id(), target, 0, 0,
                                   static_cast<GLsizeiptr>(sea.out.size()));
          sea.ring->issue(static_cast<double>(index));
          sea.on_their_way.push_back(index);
        });
  }
}

void GpuMoments::compute(const Sea& sea, std::int64_t index) const {
  const int size = sea.waves->size();
  const auto count = static_cast<GLuint>(sea.waves->cascades().size());
  sea.modes.bind_storage(0);
  sea.twiddles.bind_storage(1);
  sea.work.bind_storage(2);
  sea.grids.bind_storage(3);
  sea.columns->use();
  set_time(*sea.columns, static_cast<double>(index) * kMomentStep);
  glDispatchCompute(static_cast<GLuint>(groups_for(size / 2, size)), count, 1);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  sea.out.bind_storage(0);
  sea.rows->use();
  glDispatchCompute(static_cast<GLuint>(groups_for(size, size)), count, 1);
}

void GpuMoments::collect() {
  for (const auto& sea : seas_) {
    gl::ReadbackRing::Result result{};
    while (sea->ring->poll_oldest(&result)) {
      auto moment = std::make_shared<WaveMoment>();
      moment->index = static_cast<std::int64_t>(result.tag);
      moment->values.resize(result.bytes.size() / sizeof(float));
      std::memcpy(moment->values.data(), result.bytes.data(), result.bytes.size());
      std::erase(sea->on_their_way, moment->index);
      const std::lock_guard lock(mutex_);
      sea->known.push_back(std::move(moment));
      // What lies farthest from now goes first.
      constexpr std::size_t kMostMoments = 8;
      if (sea->known.size() > kMostMoments) {
        const std::int64_t now = index_at(now_);
        sea->known.erase(std::max_element(
            sea->known.begin(), sea->known.end(), [&](const auto& a, const auto& b) {
              return std::abs(a->index - now) < std::abs(b->index - now);
            }));
      }
    }
  }
}

}  // namespace offing
