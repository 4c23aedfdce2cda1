#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "engine/boat/hull_shape.h"
#include "engine/boat/rigid_body.h"
#include "engine/boat/water_probe.h"

namespace offing {

/// Where water can stand on deck, metres, boat frame. No cockpit: length 0.
struct DeckPlan {
  double rail = 0.05;         ///< height of the toe rail
  double scuppers = 1.2;      ///< s: how fast what lies behind the rail runs off
  double deck_height = 0.90;  ///< of the middle of the deck
  double deck_area = 11.0;    ///< m^2 without the cockpit
  double cockpit_from = 0.95, cockpit_to = 3.05;  ///< z
  double cockpit_breadth = 1.10;                  ///< m
  double cockpit_floor = 0.42;                    ///< y
  double cockpit_depth = 0.40;                    ///< m
  double coaming = 0.15;                          ///< m above the deck's edge
  double drain_area = 0.0045;  ///< m^2 of the two cockpit drains, discharge included
};

/// Water shipped over the rail: it weighs on her, stands on the low side, and runs off.
///
/// A slice whose deck edge is below the sea outside takes water over it as a broad-crested weir,
/// q = (2/3)^1.5 sqrt(g) h^1.5 per metre (Chow 1959, "Open-Channel Hydraulics", 3-7); the cockpit
/// empties through its drains as an orifice, sqrt(2 g h), and over the coaming where she heels.
/// Where the deck itself is under the sea its water is the sea's, which the hull forces weigh.
class DeckWater {
 public:
  void reset() { *this = DeckWater{}; }
  /// Fills and drains for dt seconds.
  void step(const DeckPlan& plan, const HullShape& shape, const WaterProbe& water,
            const glm::dvec3& origin, const glm::dquat& orientation, double dt);
  /// Adds the weight of the water, about the centre of mass at `centre`.
  void add_weight(Loads& loads, const DeckPlan& plan, const glm::dquat& orientation,
                  const glm::dvec3& centre) const;

  double on_deck() const { return deck_; }        ///< m^3
  double in_cockpit() const { return cockpit_; }  ///< m^3
  /// Shipped since the start, m^3.
  double shipped() const { return shipped_; }

 private:
  double deck_ = 0.0, cockpit_ = 0.0, shipped_ = 0.0, deck_z_ = 0.0, dry_ = 1.0;
};

/// How much the cockpit holds before it runs over, m^3, heeled (rad).
double cockpit_holds(const DeckPlan& plan, double heel);

}  // namespace offing
