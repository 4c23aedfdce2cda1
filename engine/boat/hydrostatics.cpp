#include "engine/boat/hydrostatics.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace offing {

WetSection wet_section(const HullSection& section, double d0, glm::dvec2 gradient) {
  WetSection wet;
  glm::dvec2 first{0.0}, last{0.0}, dry{0.0};
  bool any = false, leaving = false;
  double moment_x = 0.0, moment_y = 0.0, chord_mid = 0.0;
  glm::dvec2 entry_before_exit{0.0};
  bool entered_first = false;

  const auto emit = [&](glm::dvec2 p) {
    if (!any) {
      first = last = p;
      any = true;
      return;
    }
    const double cross = last.x * p.y - p.x * last.y;
    wet.area += 0.5 * cross;
    moment_x += cross * (last.x + p.x) / 6.0;
    moment_y += cross * (last.y + p.y) / 6.0;
    last = p;
  };
  const auto add_chord = [&](glm::dvec2 from, glm::dvec2 to) {
    const double length = glm::distance(from, to);
    wet.breadth += length;
    chord_mid += length * 0.5 * (from.x + to.x);
  };

  const auto& outline = section.outline;
  const std::size_t count = outline.size();
  glm::dvec2 a = outline[count - 1];
  double depth_a = d0 + glm::dot(gradient, a);
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec2 b = outline[i];
    const double depth_b = d0 + glm::dot(gradient, b);
    if ((depth_a > 0.0) != (depth_b > 0.0)) {
      const glm::dvec2 cut = a + (b - a) * (depth_a / (depth_a - depth_b));
      if (depth_a > 0.0) {  // leaving the water: a waterline begins here
        dry = cut;
        leaving = true;
      } else if (leaving) {
        add_chord(dry, cut);
        leaving = false;
      } else {
        entry_before_exit = cut;
        entered_first = true;
      }
      emit(cut);
    }
    if (depth_b > 0.0) emit(b);
    a = b;
    depth_a = depth_b;
  }
  if (!any) return wet;
  emit(first);
  if (leaving && entered_first) add_chord(dry, entry_before_exit);
  if (wet.area > 1e-9) {
    wet.centroid = {moment_x / wet.area, moment_y / wet.area};
  } else {
    wet.area = 0.0;
    wet.centroid = first;
  }
  if (wet.breadth > 1e-9) wet.waterline_mid = chord_mid / wet.breadth;
  return wet;
}

Immersion immerse_level(const HullShape& shape, double y) { return immerse_heeled(shape, 0.0, y); }

Immersion immerse_heeled(const HullShape& shape, double heel, double height) {
  // A point (x, y) of the boat stands x sin(-heel) + y cos(heel) above its origin.
  const glm::dvec2 up(-std::sin(heel), std::cos(heel));
  Immersion result;
  double first_moment = 0.0, second_moment = 0.0;
  for (const HullSection& section : shape.sections) {
    const WetSection wet = wet_section(section, height, -up);
    const double volume = wet.area * section.thickness;
    const double plane = wet.breadth * section.thickness;
    result.volume += volume;
    result.centroid += volume * glm::dvec3(wet.centroid.x, wet.centroid.y, section.z);
    result.waterplane += plane;
    first_moment += plane * section.z;
    second_moment += plane * section.z * section.z;
    result.transverse_inertia += section.thickness * wet.breadth * wet.breadth * wet.breadth / 12.0;
  }
  if (result.volume > 0.0) result.centroid /= result.volume;
  if (result.waterplane > 0.0) {
    result.flotation_z = first_moment / result.waterplane;
    result.longitudinal_inertia =
        second_moment - result.waterplane * result.flotation_z * result.flotation_z;
  }
  return result;
}

}  // namespace offing
