#pragma once
#include "engine/ocean/ocean.h"
namespace offing {
class ReadbackWater : public WaterSurface {
 public:
  ReadbackWater(const Ocean&) {}
  void add(FrameGraph&, SeaIds, double) {}
  void poll() {}
  void sample(std::span<const glm::dvec2>, double, std::span<WaterSample> out) const override { for (auto& o : out) o = {}; }
};
}
