#include "game/world/clouds.h"

namespace offing {

CloudView cloud_view(const Scene& scene, const Environment& environment, glm::dvec3 eye) {
  CloudView view;
  view.weather = environment.clouds;
  view.drift = environment.air_drift();
  view.wind_to = environment.wind_to();
  view.wind_speed = environment.wind.speed;
  view.elapsed = environment.elapsed();
  view.eye = eye;
  view.seed = static_cast<std::uint64_t>(scene.seed);
  view.parameters = scene.clouds;
  return view;
}

}  // namespace offing
