#include "game/world/sea.h"

namespace offing {

SeaSpectrum sea_spectrum(const Scene& scene) {
  return SeaSpectrum(scene.sea, scene.environment.wind.speed, scene.environment.wind_to());
}

DirectWater direct_water(const Scene& scene, int count, int size) {
  const SeaSpectrum spectrum = sea_spectrum(scene);
  std::vector<Cascade> cascades;
  for (const CascadeBand& band : choose_bands(spectrum, count, size)) {
    cascades.push_back(make_cascade(spectrum, band, size, static_cast<std::uint64_t>(scene.seed),
                                    static_cast<int>(cascades.size())));
  }
  return DirectWater(cascades, scene.sea.choppiness);
}

}  // namespace offing
