#pragma once
#include "engine/environment/environment.h"
#include "engine/ocean/sea_maps.h"
#include "engine/ocean/water_surface.h"
namespace offing {
struct OceanSettings { int x; };
class Ocean {
 public:
  Ocean(ShaderLibrary&, OceanSettings) {}
  void set_sea(const SeaState&, const Environment&, std::uint64_t) {}
  SeaStatistics statistics() const { return {}; }
  SeaIds add_maps(FrameGraph&, double) { return {}; }
  template <class... A> void add_draw(A&&...) {}
};
}
