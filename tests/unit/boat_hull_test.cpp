// Hydrostatics of the hull against closed forms and R8's published numbers; free decay and drag.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

#include "boat_waters.h"
#include "engine/boat/boat.h"
#include "engine/boat/polar.h"
#include "engine/boat/resistance.h"
#include "engine/core/angles.h"

namespace offing {
namespace {

constexpr double kStep = 1.0 / 120.0;
const SteadyWind kNoWind(0.0, 0.0);

/// The height of the water over the origin at which the hull displaces `volume`.
double floating_height(const HullShape& shape, double heel, double volume) {
  double low = -3.0, high = 3.0;
  for (int i = 0; i < 60; ++i) {
    const double mid = 0.5 * (low + high);
    (immerse_heeled(shape, heel, mid).volume < volume ? low : high) = mid;
  }
  return 0.5 * (low + high);
}

TEST(BoatHull, ABoxDrawsWhatArchimedesSays) {
  // 2000 kg over 8 x 2.5 m: 2000 / (1025 * 20) = 97.6 mm.
  const HullShape shape = box(8.0, 2.5, 1.0);
  EXPECT_NEAR(floating_height(shape, 0.0, 2000.0 / kWaterDensity), 0.09756, 1e-5);
  const Immersion m = immerse_level(shape, 0.09756);
  EXPECT_NEAR(m.waterplane, 20.0, 1e-9);
  EXPECT_NEAR(m.transverse_inertia, 8.0 * 2.5 * 2.5 * 2.5 / 12.0, 1e-9);
  EXPECT_NEAR(m.centroid.y, 0.09756 / 2.0, 1e-6);
}

TEST(BoatHull, ACylinderHalfUnderDisplacesHalfOfItself) {
  const Immersion m = immerse_heeled(cylinder(2.0, 0.3), 0.7, 0.0);
  EXPECT_NEAR(m.volume, 0.5 * kPi * 0.3 * 0.3 * 2.0, 1e-9);
}

TEST(BoatHull, ATriangleClippedByHandIsClippedTheSame) {
  HullSection section;
  section.outline = {{0.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}};
  const WetSection wet = wet_section(section, 0.0, {0.0, -1.0});  // water at y = 0
  EXPECT_NEAR(wet.area, 0.5, 1e-12);
  EXPECT_NEAR(wet.breadth, 1.0, 1e-12);
  EXPECT_NEAR(wet.centroid.y, -1.0 / 3.0, 1e-12);
  EXPECT_NEAR(wet.centroid.x, 0.0, 1e-12);
}

TEST(BoatHull, R8FloatsOnHerMarks) {
  const Boat boat;
  const R8Parameters& p = boat.parameters();
  const Immersion design = immerse_level(boat.hull().shape(), 0.0);
  EXPECT_NEAR(design.volume + p.keel_volume, p.mass / kWaterDensity,
              0.005 * p.mass / kWaterDensity);
  EXPECT_NEAR(design.waterplane, 9.34, 0.01 * 9.34);
  // 100 kg more sink her by 100 / (1025 * 9.34) = 10.4 mm.
  const double sunk =
      floating_height(boat.hull().shape(), 0.0, design.volume + 100.0 / kWaterDensity);
  EXPECT_NEAR(1000.0 * sunk, 10.4, 0.3);
}

TEST(BoatHull, WeightEqualsBuoyancyAtRest) {
  Boat boat;
  const CalmWater water;
  boat.controls().sails_up = false;
  boat.start({3.0, -7.0}, 1.0, 0.0, water, 0.0);
  EXPECT_NEAR(boat.state().position.y, 0.0, 2e-3);
  for (int i = 0; i < 20 * 120; ++i) boat.step(water, kNoWind, i * kStep, kStep);
  const double weight = boat.parameters().mass * kGravity;
  EXPECT_NEAR(boat.forces().volume * kWaterDensity * kGravity, weight, 0.005 * weight);
  EXPECT_NEAR(boat.state().position.y, 0.0, 2e-3);
  EXPECT_NEAR(degrees(boat.navigation().heel), 0.0, 1e-6);
  EXPECT_NEAR(degrees(boat.navigation().pitch), 0.0, 0.05);
  EXPECT_LT(glm::length(boat.state().velocity), 1e-3);
}

TEST(BoatHull, RightingArmsFollowTheReference) {
  const auto arm = [](double heel_deg) { return righting_arm(R8Parameters{}, radians(heel_deg)); };
  EXPECT_NEAR(arm(1.0), 1.05 * std::sin(radians(1.0)), 0.0005);  // GM
  EXPECT_NEAR(arm(30.0), 0.475, 0.05 * 0.475);
  EXPECT_NEAR(arm(66.0), 0.70, 0.10 * 0.70);
  EXPECT_GT(arm(115.0), 0.0);
  EXPECT_LT(arm(133.0), 0.0);
}

/// Twice the time between the first two crossings of the mean by a decaying motion, s.
double decay_period(Boat& boat, const std::function<double(const Boat&)>& motion) {
  const CalmWater water;
  double last = motion(boat), first = -1.0;
  for (int i = 0; i < 10 * 120; ++i) {
    boat.step(water, kNoWind, i * kStep, kStep);
    const double now = motion(boat);
    if (last * now < 0.0) {
      const double time = (i + last / (last - now)) * kStep;
      if (first >= 0.0) return 2.0 * (time - first);
      first = time;
    }
    last = now;
  }
  return -1.0;
}

Boat still_boat() {
  Boat boat;
  boat.controls().sails_up = false;
  boat.controls().crew_hikes = false;
  boat.start({0.0, 0.0}, 0.0, 0.0, CalmWater(), 0.0);
  return boat;
}

TEST(BoatHull, HeavesRollsAndPitchesAtTheRightPeriods) {
  {
    Boat boat = still_boat();
    const double rest = boat.state().position.y;
    boat.displace({0.0, 0.08, 0.0}, 0.0, 0.0);
    EXPECT_NEAR(decay_period(boat, [&](const Boat& b) { return b.state().position.y - rest; }),
                1.28, 0.15 * 1.28);
  }
  {
    Boat boat = still_boat();
    boat.displace(glm::dvec3(0.0), radians(8.0), 0.0);
    EXPECT_NEAR(decay_period(boat, [](const Boat& b) { return b.navigation().heel; }), 2.2,
                0.15 * 2.2);
  }
  {
    Boat boat = still_boat();
    const double rest = boat.navigation().pitch;
    boat.displace(glm::dvec3(0.0), 0.0, radians(2.0));
    EXPECT_NEAR(decay_period(boat, [&](const Boat& b) { return b.navigation().pitch - rest; }), 1.7,
                0.15 * 1.7);
  }
}

TEST(BoatHull, ThrustGivesTheSpeedOfTheTable) {
  const struct {
    double thrust, speed;
  } kRows[] = {{100, 1.86}, {200, 2.48}, {500, 3.15}, {1000, 3.66}};
  const CalmWater water;
  for (const auto& row : kRows) {
    Boat boat = still_boat();
    boat.set_external_force({0.0, 0.0, -row.thrust}, {0.0, -0.1, 0.0});
    for (int i = 0; i < 90 * 120; ++i) boat.step(water, kNoWind, i * kStep, kStep);
    EXPECT_NEAR(boat.navigation().stw, row.speed, 0.12 * row.speed) << row.thrust << " N";
    EXPECT_EQ(boat.limit_hits(), 0);
  }
}

TEST(BoatHull, CoastsFromThreeToOneAndAHalf) {
  const CalmWater water;
  Boat boat;
  boat.controls().sails_up = false;
  boat.start({0.0, 0.0}, 0.0, 3.0, water, 0.0);
  double time = 0.0;
  while (boat.navigation().stw > 1.5 && time < 60.0) {
    boat.step(water, kNoWind, time, kStep);
    time += kStep;
  }
  EXPECT_NEAR(time, 22.0, 0.12 * 22.0);
}

TEST(BoatHull, FollowsLongWaves) {
  // Waves of 8 and 16 waterline lengths on the beam and ahead: she rides them like a cork.
  for (const double lengths : {8.0, 16.0}) {
    for (const double heading : {0.0, 90.0}) {
      const double amplitude = 0.25;
      const SineSea sea(amplitude, lengths * 6.7, kPi);
      Boat boat;
      boat.controls().sails_up = false;
      boat.start({0.0, 0.0}, radians(heading), 0.0, sea, 0.0);
      double low = 9.0, high = -9.0, bow_low = 9.0, bow_high = -9.0;
      for (int i = 0; i < 60 * 120; ++i) {
        boat.step(sea, kNoWind, i * kStep, kStep);
        if (i < 20 * 120) continue;
        low = std::min(low, boat.state().position.y);
        high = std::max(high, boat.state().position.y);
        bow_low = std::min(bow_low, boat.navigation().pitch);
        bow_high = std::max(bow_high, boat.navigation().pitch);
      }
      EXPECT_NEAR(0.5 * (high - low) / amplitude, 1.0, 0.07) << lengths << " LWL, " << heading;
      if (heading == 0.0) {  // the slope of the wave
        const double slope = amplitude * kTau / (lengths * 6.7);
        EXPECT_NEAR(0.5 * (bow_high - bow_low) / slope, 1.0, 0.07) << lengths << " LWL";
      }
    }
  }
}

TEST(BoatHull, ComesBackFromAKnockdownAndStaysCapsized) {
  const CalmWater water;
  for (const double heel : {100.0, -100.0, 170.0}) {
    Boat boat = still_boat();
    boat.displace(glm::dvec3(0.0), radians(heel), 0.0);
    for (int i = 0; i < 60 * 120; ++i) boat.step(water, kNoWind, i * kStep, kStep);
    if (heel == 170.0) {
      EXPECT_GT(std::abs(degrees(boat.navigation().heel)), 90.0);
      EXPECT_EQ(boat.navigation().trouble, Trouble::kCapsized);
    } else {
      EXPECT_LT(std::abs(degrees(boat.navigation().heel)), 5.0) << heel;
    }
    EXPECT_EQ(boat.limit_hits(), 0) << heel;
  }
}

TEST(BoatHull, LosesEnergyWithSailsDown) {
  const CalmWater water;
  Boat boat = still_boat();
  boat.displace({0.0, 0.3, 0.0}, radians(25.0), radians(4.0));
  double last = 1e300, first = 0.0;
  for (int window = 0; window < 12; ++window) {  // of 5 s: longer than every period of hers
    double most = 0.0;
    for (int i = 0; i < 5 * 120; ++i) {
      boat.step(water, kNoWind, 5.0 * window + i * kStep, kStep);
      most = std::max(most, boat.kinetic_energy());
    }
    EXPECT_LT(most, last) << window;
    last = most;
    if (window == 0) first = most;
  }
  EXPECT_LT(last, 2e-3 * first);
}

TEST(BoatHull, GainsNoEnergyFromASeaInTheLongRun) {
  for (const glm::dvec2 kind : {glm::dvec2(0.5, 3.2), {2.0, 6.4}, {8.0, 12.7}}) {
    for (const int rate : {30, 240}) {
      const SineSea sea(kind.x, kind.y, std::uint64_t{3});
      Boat boat;
      boat.controls().sails_up = false;
      boat.start({0.0, 0.0}, radians(70.0), 0.0, sea, 0.0);
      double mean[2] = {0.0, 0.0};
      for (int i = 0; i < 600 * rate; ++i) {
        boat.step(sea, kNoWind, static_cast<double>(i) / rate, 1.0 / rate);
        if (i >= 60 * rate) mean[i >= 330 * rate] += boat.kinetic_energy() / (270.0 * rate);
      }
      EXPECT_LT(mean[1], 1.5 * mean[0]) << kind.x << " m, 1/" << rate << " s";
      EXPECT_EQ(boat.limit_hits(), 0) << kind.x << " m, 1/" << rate << " s";
    }
  }
}

TEST(BoatResistance, AgreesWithTheTableAndGrowsSteadily) {
  const double v6 = metres_per_second(6.0);
  EXPECT_NEAR(upright_resistance(v6) + 5.8 * v6 * v6, 455.0, 1e-9);
  double last = -1.0;
  for (double v = 0.0; v < 7.0; v += 0.01) {
    const double r = upright_resistance(v);
    EXPECT_GE(r, last);
    last = r;
  }
  EXPECT_NEAR(heeled_resistance(metres_per_second(7.0), radians(-20.0)), 49.0, 1e-9);
}

}  // namespace
}  // namespace offing
