#pragma once
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "engine/ocean/query_waves.h"
#include "engine/ocean/water_surface.h"

namespace offing {

/// The sea as floating things feel it: its long waves, interpolated between the points and moments
/// of their transforms by cubics, with the sideways motion inverted. The same at every quality and
/// from everywhere. Where moments come from, another decides.
///
/// Against the exact sum over the same waves: about 2 mm rms at Hs 4 m (`bench query`).
class SeaWater final : public WaterSurface {
 public:
  explicit SeaWater(std::unique_ptr<MomentSource> source) : source_(std::move(source)) {}

  /// Other waves, at once or, where `begin` is finite, faded over from that time on. A fade that is
  /// under way must have ended.
  void set_waves(std::shared_ptr<const QueryWaves> waves, double choppiness, double begin);
  /// Asks another source from now on.
  void set_source(std::unique_ptr<MomentSource> source);

  void sample(std::span<const glm::dvec2> points, double time,
              std::span<WaterSample> out) const override;
  double age(double time) const override;

 private:
  struct Sea {
    std::shared_ptr<const QueryWaves> waves;
    double choppiness = 1.0;
  };
  struct State {
    std::shared_ptr<MomentSource> source;
    Sea from, to;
    double begin = 0.0;           // of the fade
    std::vector<bool> same_grid;  // by cascade
  };
  struct Layer;
  std::shared_ptr<const State> state() const;
  static std::vector<Layer> layers(const State& state, double time, double* age);

  std::shared_ptr<MomentSource> source_;
  mutable std::mutex mutex_;
  std::shared_ptr<const State> state_;
};

/// Whether waves of a cascade blend straight with those of another: same patch, same frequencies.
bool same_grid(const Cascade& a, const Cascade& b);

}  // namespace offing
