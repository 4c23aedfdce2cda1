#pragma once
#include <glm/vec2.hpp>

#include <functional>
#include <utility>

namespace offing {

/// Something that can be asked how the air moves: velocity (x east, z south, m/s) the air moves
/// TOWARD, at a horizontal place (x, z; world metres) and a height above the water.
class WindField {
 public:
  virtual ~WindField() = default;
  virtual glm::dvec2 velocity(glm::dvec2 position, double height) const = 0;
};

/// A wind made of a function, for adapters and tests.
class FunctionWind final : public WindField {
 public:
  using Function = std::function<glm::dvec2(glm::dvec2 position, double height)>;
  explicit FunctionWind(Function function) : function_(std::move(function)) {}
  glm::dvec2 velocity(glm::dvec2 position, double height) const override {
    return function_(position, height);
  }

 private:
  Function function_;
};

/// Steady wind with the logarithmic profile over z0 = 0.005 m that the polar and the tables assume.
class SteadyWind final : public WindField {
 public:
  /// `speed` in m/s at 10 m, `from` in radians from north, clockwise.
  SteadyWind(double speed, double from);
  glm::dvec2 velocity(glm::dvec2 position, double height) const override;

 private:
  glm::dvec2 at_ten_metres_;
};

}  // namespace offing
