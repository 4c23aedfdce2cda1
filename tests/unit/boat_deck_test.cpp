// Water over the rail and hulls that fall on the water, against closed forms.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>

#include "boat_waters.h"
#include "engine/boat/boat.h"
#include "engine/boat/deck_water.h"
#include "engine/boat/hull.h"
#include "engine/core/angles.h"

namespace offing {
namespace {

const glm::dquat kUpright(1.0, 0.0, 0.0, 0.0);

WaterProbe probe(const HullShape& shape, const glm::dvec3& origin) {
  WaterProbe water;
  water.sample(shape, origin, kUpright, CalmWater(), 0.0, 1.0);
  return water;
}

TEST(BoatDeckWater, FlowsOverTheRailAsOverAWeir) {
  const HullShape shape = box(4.0, 2.0, 1.0);
  DeckPlan plan;
  plan.cockpit_to = plan.cockpit_from;  // none
  plan.rail = 0.05;
  const double dt = 1e-4;
  DeckWater deck;
  const glm::dvec3 origin(0.0, -1.2, 0.0);  // edges 0.2 m under
  deck.step(plan, shape, probe(shape, origin), origin, kUpright, dt);
  // Broad-crested: critical depth 2h/3, q = (2h/3) sqrt(2gh/3), over two edges of 4 m.
  const double head = 0.15, flow = 2.0 * head / 3.0 * std::sqrt(2.0 * kGravity * head / 3.0);
  EXPECT_NEAR(deck.shipped() / dt, 2.0 * 4.0 * flow, 1e-9);
}

TEST(BoatDeckWater, TheCockpitDrainsAsTorricelliSays) {
  const Boat boat;
  const HullShape& shape = boat.hull().shape();
  DeckPlan plan = boat.parameters().deck;
  DeckWater deck;
  // Filled to the brim by a sea that stands over the coaming, then lifted clear of the water.
  const glm::dvec3 under(0.0, -1.3, 0.0), clear(0.0, 0.0, 0.0);
  for (int i = 0; i < 600; ++i) deck.step(plan, shape, probe(shape, under), under, kUpright, 0.01);
  EXPECT_GT(deck.in_cockpit(), cockpit_holds(plan, 0.0));
  double time = 0.0, start = 0.0, full = 0.0;
  const WaterProbe calm = probe(shape, clear);
  while (deck.in_cockpit() > 1e-4 && time < 900.0) {
    deck.step(plan, shape, calm, clear, kUpright, 0.01);
    time += 0.01;
    if (full == 0.0 && deck.in_cockpit() <= cockpit_holds(plan, 0.0)) {
      full = deck.in_cockpit();
      start = time;
    }
  }
  // Head over the sea outside falls from floor + depth to floor.
  const double area = (plan.cockpit_to - plan.cockpit_from) * plan.cockpit_breadth;
  const double high = plan.cockpit_floor + full / area, low = plan.cockpit_floor;
  const double expected = 2.0 * area / (plan.drain_area * std::sqrt(2.0 * kGravity)) *
                          (std::sqrt(high) - std::sqrt(low));
  EXPECT_NEAR(time - start, expected, 0.02 * expected);
  EXPECT_LT(time, 300.0);  // five minutes: what ISO 11812 calls quick-draining
  EXPECT_LT(deck.on_deck(), 1e-4);
}

TEST(BoatDeckWater, AHeeledCockpitHoldsLess) {
  const DeckPlan plan;
  const double area = (plan.cockpit_to - plan.cockpit_from) * plan.cockpit_breadth;
  EXPECT_NEAR(cockpit_holds(plan, 0.0), area * plan.cockpit_depth, 1e-12);
  // The rim cuts the opposite corner: a triangle is left.
  const double corner = std::atan(plan.cockpit_depth / plan.cockpit_breadth);
  EXPECT_NEAR(cockpit_holds(plan, corner), 0.5 * area * plan.cockpit_depth, 1e-12);
  EXPECT_NEAR(cockpit_holds(plan, -corner), cockpit_holds(plan, corner), 1e-12);
  EXPECT_EQ(cockpit_holds(plan, radians(100.0)), 0.0);
}

TEST(BoatDeckWater, ASeaThatFillsHerLeavesHerAgain) {
  const CalmWater water;
  const SteadyWind no_wind(0.0, 0.0);
  Boat boat;
  boat.controls().sails_up = false;
  boat.start({0.0, 0.0}, 0.0, 0.0, water, 0.0);
  const double dry = boat.state().position.y;
  boat.displace({0.0, -1.8, 0.0}, 0.0, 0.0);  // deck and coaming under, as a sea leaves her
  double most = 0.0, sunk = 0.0, shipped = 0.0;
  int counted = 0;
  for (int i = 0; i < 300 * 60; ++i) {
    boat.step(water, no_wind, i / 60.0, 1.0 / 60.0);
    most = std::max(most, boat.state().cockpit_water);
    if (i >= 8 * 60 && i < 14 * 60) {
      sunk += dry - boat.state().position.y;
      shipped += boat.state().cockpit_water;
      ++counted;
    }
  }
  EXPECT_GT(most, 0.05);
  // It weighs on her: an even keel would sink by volume over waterplane; it lies aft, so the origin
  // sinks a little less or more.
  EXPECT_NEAR(sunk / counted, shipped / counted / 9.34, 0.3 * shipped / counted / 9.34);
  EXPECT_NEAR(boat.state().position.y, dry, 2e-3);
  EXPECT_LT(boat.state().cockpit_water, 1e-3);
  EXPECT_EQ(boat.limit_hits(), 0);
}

TEST(BoatSlam, AFallingWedgeSlowsAsVonKarmanSays) {
  // M V0 = (M + A(y)) V with A = rho pi c^2 / 2 per metre, c = y / tan(deadrise): momentum alone,
  // with neither gravity nor, over so short a blow, much buoyancy. The hull's inertia holds a
  // steady added mass, here none: a light hull would be stopped a little more than by the formula.
  const double deadrise = radians(20.0), mass_per_metre = 2000.0, speed = 2.0;
  HullShape shape;
  shape.length = 4.0;
  shape.beam = 4.0;
  const double height = 2.0 * std::tan(deadrise);
  for (int i = 0; i < 4; ++i) {
    shape.sections.push_back(
        {i - 1.5, 1.0, {2.0, height}, {{0.0, 0.0}, {2.0, height}, {-2.0, height}}});
  }
  HullDamping damping;
  damping.heave_per_area = damping.heave_drag = damping.cross_flow = damping.munk = 0.0;
  damping.roll = damping.yaw = 0.0;
  damping.impact = 1.0;
  const Hull hull(shape, damping);
  RigidBody body;
  body.mass = 4.0 * mass_per_metre;
  const CalmWater water;
  for (const double dt : {1.0 / 2000.0, 1.0 / 500.0}) {
    RigidBodyState state;
    state.velocity.y = -speed;
    state.position.y = 0.0;
    WaterProbe probe;
    HullMemory memory;
    while (state.position.y > -0.2) {
      const RigidBodyState mid = RigidBody::middle(state, dt);
      probe.sample(shape, mid.position, mid.orientation, water, 0.0, dt);
      Loads loads;
      hull.add_loads(loads, body, mid, glm::dvec3(0.0), probe, memory, dt);
      body.step(state, loads, dt);
    }
    const double c = -state.position.y / std::tan(deadrise);
    const double added = 0.5 * kWaterDensity * kPi * c * c;
    EXPECT_NEAR(-state.velocity.y, speed / (1.0 + added / mass_per_metre), 0.04 * speed) << dt;
  }
}

}  // namespace
}  // namespace offing
