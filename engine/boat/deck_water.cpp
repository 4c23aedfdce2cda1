#include "engine/boat/deck_water.h"

#include <algorithm>
#include <cmath>

#include "engine/boat/hydrostatics.h"
#include "engine/core/angles.h"

namespace offing {
namespace {

/// The level a heeled trough of this breadth can hold, as a mean depth over its floor.
double trough_depth(double breadth, double depth, double tangent) {
  const double drop = breadth * tangent;  // from the high to the low side
  if (drop <= depth) return depth - 0.5 * drop;
  return drop > 0.0 ? 0.5 * depth * depth / drop : depth;  // a wedge on the low side
}

double low_side_tangent(const glm::dquat& orientation) {
  const glm::dvec3 down = glm::conjugate(orientation) * glm::dvec3(0.0, -1.0, 0.0);
  return down.x / std::max(-down.y, 0.05);  // positive: starboard is low
}

double weir(double head) {
  const double discharge = std::pow(2.0 / 3.0, 1.5);
  return head > 0.0 ? discharge * std::sqrt(kGravity) * head * std::sqrt(head) : 0.0;
}

}  // namespace

double cockpit_holds(const DeckPlan& plan, double heel) {
  if (std::abs(heel) >= 0.5 * kPi) return 0.0;
  const double length = plan.cockpit_to - plan.cockpit_from;
  return length * plan.cockpit_breadth *
         trough_depth(plan.cockpit_breadth, plan.cockpit_depth, std::abs(std::tan(heel)));
}

void DeckWater::step(const DeckPlan& plan, const HullShape& shape, const WaterProbe& water,
                     const glm::dvec3& origin, const glm::dquat& orientation, double dt) {
  const glm::dvec3 up = orientation * glm::dvec3(0.0, 1.0, 0.0);
  const bool upright = up.y > 0.0;
  const int count = static_cast<int>(shape.sections.size());
  double on_deck = 0.0, into_cockpit = 0.0, moment = 0.0, under = 0.0;
  for (int i = 0; i < count; ++i) {
    const HullSection& section = shape.sections[i];
    const SliceWater& local = water.slice(i);
    const bool cockpit = section.z > plan.cockpit_from && section.z < plan.cockpit_to;
    bool both = true;
    for (const double side : {-1.0, 1.0}) {
      const glm::dvec3 edge(side * section.sheer.x, section.sheer.y, section.z);
      const double head = local.above(origin + orientation * edge);
      both = both && head > 0.0;
      if (!upright) continue;
      const double over_deck = weir(head - plan.rail) * section.thickness;
      const double over_coaming = cockpit ? weir(head - plan.coaming) * section.thickness : 0.0;
      on_deck += over_deck - over_coaming;
      into_cockpit += over_coaming;
      moment += (over_deck - over_coaming) * section.z;
    }
    if (both) under += 1.0 / count;
  }
  dry_ = 1.0 - under;

  const double before = deck_;
  deck_ += dt * on_deck;
  if (deck_ > 1e-9) deck_z_ += (moment * dt - deck_z_ * (deck_ - before)) / deck_;
  shipped_ += dt * (on_deck + into_cockpit);
  // Off the deck over the low rail; what the rail holds back goes through the scuppers.
  const double tangent = upright ? low_side_tangent(orientation) : 50.0;
  const double most = plan.deck_area * plan.rail;
  deck_ = std::min(deck_, 3.0 * most) / (1.0 + dt / plan.scuppers);

  const double area = (plan.cockpit_to - plan.cockpit_from) * plan.cockpit_breadth;
  if (area <= 0.0) return;
  cockpit_ += dt * into_cockpit;
  const double holds = upright ? cockpit_holds(plan, std::atan(tangent)) : 0.0;
  constexpr double kSpill = 0.3;  // s: over the coaming and away
  if (cockpit_ > holds) cockpit_ = holds + (cockpit_ - holds) / (1.0 + dt / kSpill);
  const double depth = cockpit_ / area;
  const glm::dvec3 floor(0.0, plan.cockpit_floor, 0.5 * (plan.cockpit_from + plan.cockpit_to));
  const double head =
      depth + std::max(-water.at(shape, floor.z).above(origin + orientation * floor), -depth);
  const double drained = dt * plan.drain_area * std::sqrt(2.0 * kGravity * std::max(head, 0.0));
  cockpit_ = std::max(cockpit_ - drained, 0.0);
}

void DeckWater::add_weight(Loads& loads, const DeckPlan& plan, const glm::dquat& orientation,
                           const glm::dvec3& centre) const {
  const glm::dvec3 down =
      glm::conjugate(orientation) * glm::dvec3(0.0, -kWaterDensity * kGravity, 0.0);
  const double tangent = low_side_tangent(orientation);
  if (deck_ > 0.0) {
    loads.add(deck_ * dry_ * down, glm::dvec3(0.0, plan.deck_height, deck_z_) - centre);
  }
  if (cockpit_ <= 0.0) return;
  const double breadth = plan.cockpit_breadth;
  const double area = (plan.cockpit_to - plan.cockpit_from) * breadth;
  const double depth = cockpit_ / area;
  // The free surface brings the water to the low side: b^2 tan / 12 d while it covers the floor, a
  // wedge in the corner beyond.
  const double slope = std::abs(tangent);
  double shift = breadth * breadth * slope / (12.0 * depth);
  if (breadth * slope > 2.0 * depth) {
    shift = 0.5 * breadth - std::sqrt(2.0 * depth * breadth / slope) / 3.0;
  }
  shift = std::copysign(std::min(shift, 0.5 * breadth), tangent);
  loads.add(cockpit_ * dry_ * down, glm::dvec3(shift, plan.cockpit_floor + 0.5 * depth,
                                               0.5 * (plan.cockpit_from + plan.cockpit_to)) -
                                        centre);
}

}  // namespace offing
