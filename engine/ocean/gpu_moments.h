#pragma once
#include <array>
#include <memory>
#include <mutex>
#include <set>
#include <vector>

#include "engine/gl/readback.h"
#include "engine/graph/frame_graph.h"
#include "engine/ocean/query_waves.h"
#include "engine/shader/shader_library.h"

namespace offing {

/// Moments computed on the GPU ahead of the time when they are needed, and brought back without
/// waiting. Since the waves are analytic in time nothing is held or extrapolated as long as a
/// read-back takes less than kAhead. One moment a frame at most, none where all are known.
class GpuMoments final : public MomentSource {
 public:
  /// How far (s) ahead of the sea's clock moments are asked for.
  static constexpr double kAhead = 0.25;

  explicit GpuMoments(ShaderLibrary& shaders) : shaders_(shaders) {}

  void take(const std::shared_ptr<const QueryWaves>& waves) override;
  MomentPair around(const std::shared_ptr<const QueryWaves>& waves, std::int64_t index) override;

  /// Adds sea.moment and sea.readback, for the next moment that will be needed from the sea's clock
  /// `time` on.
  void add(FrameGraph& graph, double time);
  /// Takes in what has arrived. Never waits.
  void collect();

 private:
  // One sea: its waves on the GPU and what is known of it.
  struct Sea {
    std::shared_ptr<const QueryWaves> waves;
    gl::Buffer modes, grids, twiddles, work, out;
    std::unique_ptr<gl::ReadbackRing> ring;
    std::vector<std::int64_t> on_their_way;  // tags of the ring
    std::vector<std::shared_ptr<const WaveMoment>> known;
    const ShaderProgram* columns = nullptr;
    const ShaderProgram* rows = nullptr;
  };
  static std::shared_ptr<const WaveMoment> find(const Sea& sea, std::int64_t index);
  void compute(const Sea& sea, std::int64_t index) const;

  ShaderLibrary& shaders_;
  mutable std::mutex mutex_;  // guards the lists of known moments
  std::vector<std::unique_ptr<Sea>> seas_;
  double now_ = 0.0;
};

}  // namespace offing
