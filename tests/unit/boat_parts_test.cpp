// The parts of the boat alone: tables, foils, sails, boom, rigid body, probe.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <limits>

#include "engine/boat/boom.h"
#include "engine/boat/curve.h"
#include "engine/boat/foil.h"
#include "engine/boat/parameters.h"
#include "engine/boat/rig.h"
#include "engine/boat/rigid_body.h"
#include "engine/core/angles.h"
#include "engine/core/error.h"

namespace offing {
namespace {

TEST(BoatCurve, PassesThroughItsKnotsWithoutOvershoot) {
  const Curve curve({{0, 0}, {1, 1}, {2, 1}, {5, 4}}, Curve::Beyond::kLinear);
  EXPECT_DOUBLE_EQ(curve(0), 0);
  EXPECT_DOUBLE_EQ(curve(1), 1);
  EXPECT_DOUBLE_EQ(curve(5), 4);
  for (double x = 1; x <= 2; x += 0.05) EXPECT_NEAR(curve(x), 1.0, 1e-12);
  for (double x = 0; x < 5; x += 0.01) EXPECT_GE(curve(x + 0.01), curve(x) - 1e-12);
  EXPECT_NEAR(curve(7) - curve(6), curve(6) - curve(5), 1e-12);
  EXPECT_DOUBLE_EQ(curve(-3), 0);
  EXPECT_THROW(Curve({{1, 0}, {0, 1}}), Error);
}

TEST(BoatFoil, LiftSlopeStallAndFlatPlate) {
  const Foil keel(1.16, 0.73, 0.85);
  const double aspect = 2.0 * 1.16 / 0.73;
  const double slope = kTau * aspect / (aspect + 2.0);
  EXPECT_NEAR(keel.coefficients(radians(4.0)).lift, slope * radians(4.0), 1e-9);
  EXPECT_NEAR(keel.coefficients(0.0).drag, 0.009, 1e-12);
  EXPECT_NEAR(keel.coefficients(radians(45.0)).lift, 1.0, 1e-9);
  EXPECT_NEAR(keel.coefficients(radians(90.0)).drag, 2.009, 1e-9);
  EXPECT_NEAR(keel.coefficients(radians(90.0)).lift, 0.0, 1e-9);
  // Odd in the angle, the same plate from astern, and never any thrust.
  for (double a = -180.0; a <= 180.0; a += 1.0) {
    const FoilCoefficients c = keel.coefficients(radians(a)), m = keel.coefficients(radians(-a));
    if (std::abs(a) < 180.0) {
      EXPECT_NEAR(c.lift, -m.lift, 1e-12) << a;
    }
    EXPECT_GT(c.drag, 0.0) << a;
  }
  EXPECT_LT(keel.coefficients(radians(176.0)).lift, 0.0);
}

TEST(BoatFoil, RudderToStarboardPushesTheSternToPort) {
  const Foil rudder(0.95, 0.42, 0.4);
  EXPECT_LT(rudder.force({0.0, 3.0}, radians(10.0)).x, 0.0);
  EXPECT_GT(rudder.force({0.0, -3.0}, radians(10.0)).x, 0.0);  // astern it works the other way
  EXPECT_EQ(rudder.force({0.0, 0.0}, 0.3), glm::dvec2(0.0));
}

TEST(BoatSails, TablesHoldAtTheBestSheeting) {
  // 22 degrees of attack gives the table's lift: main 1.347 at 28, jib 1.45 at 50 degrees.
  const double stop = radians(85.0);
  EXPECT_NEAR(sail_coefficients(false, radians(28), radians(6), stop, 1.0).lift, 1.347, 1e-9);
  EXPECT_NEAR(sail_coefficients(true, radians(50), radians(28), radians(75), 1.0).lift, 1.45, 1e-9);
  EXPECT_NEAR(sail_coefficients(false, radians(28), radians(6), stop, 0.5).lift, 0.5 * 1.347, 1e-9);
  // On its stop the main keeps the table: at 120 degrees 0.931 and 0.969 + 0.0138 CL^2.
  const SailReading run = sail_coefficients(false, radians(120), stop, stop, 1.0);
  EXPECT_NEAR(run.lift, 0.931, 1e-9);
  EXPECT_NEAR(run.drag, 0.969 + 0.0138 * 0.931 * 0.931, 1e-9);
}

TEST(BoatFoil, TurnsTheWaterBehindItByHalfItsLeeway) {
  const Foil keel(1.16, 0.73, 0.85);
  EXPECT_NEAR(keel.downwash(radians(4.0)), 0.5 * radians(4.0), 0.15 * radians(4.0));
  EXPECT_NEAR(keel.downwash(radians(-4.0)), -keel.downwash(radians(4.0)), 1e-12);
  EXPECT_EQ(keel.downwash(radians(180.0 - 4.0)), 0.0);  // astern the rudder leads
}

TEST(BoatSails, AJibHeldAbackPushesTheBowAway) {
  // Head to wind, clew held 25 degrees to starboard: the flow presses the bow to port, as a plate.
  const double stop = radians(75.0), held = radians(25.0);
  const SailReading aback = sail_coefficients(true, 0.0, held, stop, 1.0);
  EXPECT_NEAR(aback.lift, -1.4 * std::sin(held) * std::cos(held), 0.01);
  EXPECT_GT(aback.drag, 0.2);
  EXPECT_LT(aback.fill, -0.2);
}

TEST(BoatSails, LuffStallAndMirror) {
  const double stop = radians(85.0);
  const SailReading luffing = sail_coefficients(false, radians(30), radians(30), stop, 1.0);
  EXPECT_NEAR(luffing.lift, 0.0, 1e-12);
  EXPECT_NEAR(luffing.luff, 1.0, 1e-12);
  const SailReading best = sail_coefficients(false, radians(90), radians(68), stop, 1.0);
  const SailReading tight = sail_coefficients(false, radians(90), radians(5), stop, 1.0);
  EXPECT_LT(tight.lift, 0.3 * best.lift);
  EXPECT_GT(tight.drag, 2.0 * best.drag);
  EXPECT_GT(tight.stall, 0.9);
  for (double wind = 5; wind < 180; wind += 5) {
    for (double boom = -80; boom <= 80; boom += 10) {
      const SailReading a = sail_coefficients(false, radians(wind), radians(boom), stop, 1.0);
      const SailReading b = sail_coefficients(false, radians(-wind), radians(-boom), stop, 1.0);
      EXPECT_NEAR(a.lift, -b.lift, 1e-12);
      EXPECT_NEAR(a.drag, b.drag, 1e-12);
    }
  }
}

TEST(BoatSails, BoomStreamsInItsSheetAndGybesByTheLee) {
  const Rig rig{RigParameters{}};
  const auto settle = [&](double start, double wind_from_aft_deg, double sheet) {
    Boom boom{start, 0.0};
    const double g = radians(wind_from_aft_deg);
    const glm::dvec3 wind = 8.0 * glm::dvec3(std::sin(g), 0.0, std::cos(g));
    for (int i = 0; i < 20 * 120; ++i) {
      Loads loads;
      SailSet set;
      set.main_angle = boom.angle;
      const RigReading r = rig.add_loads(loads, set, glm::dvec3(0.0), wind, wind);
      boom.step(r.boom_torque, 30.0, 2.6, sheet, 1.0 / 120.0);
    }
    return degrees(boom.angle);
  };
  EXPECT_NEAR(settle(0.0, 40.0, radians(80.0)), 40.0, 0.5);     // eased: she streams
  EXPECT_NEAR(settle(0.0, 40.0, radians(15.0)), 15.0, 1e-9);    // held by the sheet
  EXPECT_NEAR(settle(0.3, -40.0, radians(15.0)), -15.0, 1e-9);  // tacked: it comes across
  // By the lee it stays for 20 degrees, and comes over at 35.
  EXPECT_GT(settle(radians(85.0), -160.0, radians(85.0)), 80.0);
  EXPECT_LT(settle(radians(85.0), -145.0, radians(85.0)), -80.0);
}

TEST(BoatRigidBody, FallsAsNewtonSays) {
  RigidBody body;
  body.mass = 10.0;
  RigidBodyState state;
  const int steps = 120;
  for (int i = 0; i < steps; ++i) {
    Loads loads;
    loads.add({0.0, -98.1, 0.0}, glm::dvec3(0.0));
    EXPECT_EQ(body.step(state, loads, 1.0 / steps), 0);
  }
  EXPECT_NEAR(state.velocity.y, -9.81, 1e-9);
  EXPECT_NEAR(state.position.y, -0.5 * 9.81, 1e-9);
}

TEST(BoatRigidBody, IsOfSecondOrder) {
  // A damped spring against its closed form: halving the step quarters the error.
  const double mass = 2.0, added = 1.0, stiffness = 60.0, damping = 3.0;
  const double decay = damping / (2.0 * (mass + added));
  const double turn = std::sqrt(stiffness / (mass + added) - decay * decay);
  const auto error = [&](int rate) {
    RigidBody body;
    body.mass = mass;
    body.added_mass = {0.0, added, 0.0};
    RigidBodyState state;
    state.position.y = 1.0;
    double worst = 0.0;
    for (int i = 0; i < 3 * rate; ++i) {
      const double dt = 1.0 / rate;
      const RigidBodyState mid = RigidBody::middle(state, dt);
      Loads loads;
      loads.add({0.0, -stiffness * mid.position.y, 0.0}, glm::dvec3(0.0));
      loads.add_damping({0.0, 1.0, 0.0}, glm::dvec3(0.0), damping, mid.velocity.y);
      body.step(state, loads, dt);
      const double t = (i + 1) * dt;
      const double exact =
          std::exp(-decay * t) * (std::cos(turn * t) + decay / turn * std::sin(turn * t));
      worst = std::max(worst, std::abs(state.position.y - exact));
    }
    return worst;
  };
  const double coarse = error(60), fine = error(120);
  EXPECT_LT(coarse, 0.01);
  EXPECT_GT(coarse / fine, 3.5);
  EXPECT_LT(coarse / fine, 4.5);
}

TEST(BoatRigidBody, KeepsMomentumOfATumblingFreeBody) {
  RigidBody body;
  body.mass = 5.0;
  body.inertia = {1.0, 2.0, 3.0};
  RigidBodyState state;
  state.velocity = {1.0, 2.0, -3.0};
  state.angular_velocity = {0.5, -0.8, 0.3};
  const glm::dvec3 spin = body.inertia * state.angular_velocity;
  const double energy = body.kinetic_energy(state);
  for (int i = 0; i < 1200; ++i) body.step(state, Loads{}, 1.0 / 1200.0);
  EXPECT_NEAR(glm::distance(state.velocity, glm::dvec3(1.0, 2.0, -3.0)), 0.0, 2e-3);
  EXPECT_NEAR(glm::distance(state.orientation * (body.inertia * state.angular_velocity), spin), 0.0,
              2e-3);
  EXPECT_NEAR(body.kinetic_energy(state), energy, 1e-3 * energy);
}

TEST(BoatRigidBody, SurvivesAddedMassAboveItsOwnAndStiffDamping) {
  RigidBody body;
  body.mass = 1.0;
  body.added_mass = {0.0, 50.0, 0.0};
  RigidBodyState state;
  state.velocity = {0.0, 3.0, 0.0};
  for (int i = 0; i < 600; ++i) {
    Loads loads;
    loads.add_damping({0.0, 1.0, 0.0}, glm::dvec3(0.0), 1e6, state.velocity.y);
    EXPECT_EQ(body.step(state, loads, 1.0 / 30.0) > 1, false);
  }
  EXPECT_NEAR(state.velocity.y, 0.0, 1e-6);
}

TEST(BoatRigidBody, CountsLoadsThatAreNotNumbers) {
  RigidBody body;
  RigidBodyState state;
  Loads loads;
  loads.add({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}, glm::dvec3(0.0));
  EXPECT_GT(body.step(state, loads, 0.01), 0);
  EXPECT_TRUE(std::isfinite(state.position.x));
}

TEST(BoatParameters, ImpossibleNumbersAreNamed) {
  R8Parameters p;
  p.mass = -3.0;
  try {
    check(p);
    FAIL() << "a negative mass went through";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("mass = -3"), std::string::npos) << error.what();
  }
  p = R8Parameters{};
  p.rig.mast_top = 2.0;
  EXPECT_THROW(check(p), InputError);
  EXPECT_NO_THROW(check(R8Parameters{}));
}

}  // namespace
}  // namespace offing
