#pragma once
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "engine/gl/readback.h"
#include "engine/graph/frame_graph.h"
#include "engine/ocean/sea_maps.h"
#include "engine/ocean/spectrum.h"
#include "engine/ocean/water_surface.h"

namespace offing {

/// The sea as the GPU computed it, brought back without waiting: the displacement maps of the long
/// cascades in single precision, each tagged with its simulation time. A query interpolates them
/// (bicubic), inverts the sideways motion, and extrapolates the two newest to the asked time.
/// Until the first result has arrived the water is flat; after one result it stands still. Where
/// results fail to come it is carried on for kLongestReach and then flattened.
class ReadbackWater final : public WaterSurface {
 public:
  ReadbackWater(int cascades, int size);

  /// Other waves: forgets what is on its way, and stays with the last of the old ones until the
  /// first of the new has arrived.
  void set_waves(std::span<const Cascade> cascades);
  /// Adds sea.readback: copies the maps of the moment `time` into the ring. Skipped where this
  /// moment has been asked for already.
  void add_copy(FrameGraph& graph, const SeaIds& sea, double time);
  /// Takes the newest result that has arrived, if any. Never waits.
  void collect();

  /// Simulation time of the newest result; NaN before the first.
  double newest_time() const;

  void sample(std::span<const glm::dvec2> points, double time,
              std::span<WaterSample> out) const override;
  double age(double time) const override;

 private:
  struct Grid {
    double x = 0.0, z = 0.0;  // (cos, sin)(angle) / length
  };
  struct Moment {
    double time;
    std::vector<float> maps;  // Dx, h, Dz, Dxz by cascade, row, column
  };
  struct Snapshot {
    std::vector<Grid> grids;
    int size;
    std::shared_ptr<const Moment> newest, before;
  };
  std::shared_ptr<const Snapshot> snapshot() const;

  int cascades_, size_;
  std::vector<Grid> grids_;
  std::unique_ptr<gl::ReadbackRing> ring_;
  bool fresh_waves_ = false;  // nothing of these waves has arrived yet
  double asked_;              // the moment last asked for; NaN for none
  mutable std::mutex mutex_;
  std::shared_ptr<const Snapshot> snapshot_;
};

}  // namespace offing
