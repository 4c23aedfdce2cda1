#pragma once
#include "engine/boat/wind_field.h"
#include "engine/environment/environment.h"

namespace offing {

/// The one wind of the Environment, as the boat asks for it. Keeps a reference, no copy.
class EnvironmentWind final : public WindField {
 public:
  explicit EnvironmentWind(const Environment& environment) : environment_(environment) {}
  glm::dvec2 velocity(glm::dvec2 position, double height) const override {
    return environment_.wind_at(position, height);
  }

 private:
  const Environment& environment_;
};

}  // namespace offing
