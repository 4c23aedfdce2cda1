// Light through a layer of sea water against a Monte Carlo simulation, which shares with it only
// Petzold's measured phase function, and that as a table.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "engine/core/angles.h"

#define OFFING_GLSL "shaders/lib/crest.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/water.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {
using glm::dvec3;

// Share of the scattered light that is turned by less than an angle (Mobley et al., Appl. Opt. 32,
// 1993); below 10 degrees, where little depends on it, a power law that was chosen.
struct Within {
  double degrees, share;
};
constexpr Within kMeasured[] = {{10, 0.66557}, {15, 0.75499}, {20, 0.81252}, {25, 0.85241},
                                {30, 0.88120}, {40, 0.91900}, {50, 0.94304}, {60, 0.95853},
                                {75, 0.97304}, {90, 0.98191}, {180, 1.0}};
constexpr double kSmallAngles = 0.45;

double angle_turned(double share) {
  Within before = kMeasured[0];
  if (share < before.share) {
    return radians(before.degrees * std::pow(share / before.share, 1.0 / kSmallAngles));
  }
  for (const Within& next : kMeasured) {
    if (share < next.share) {
      const double part = (share - before.share) / (next.share - before.share);
      return radians(before.degrees + part * (next.degrees - before.degrees));
    }
    before = next;
  }
  return kPi;
}

dvec3 turned(dvec3 way, double angle, double about) {
  const dvec3 helper = std::abs(way.x) < 0.9 ? dvec3(1.0, 0.0, 0.0) : dvec3(0.0, 1.0, 0.0);
  const dvec3 u = glm::normalize(glm::cross(helper, way)), v = glm::cross(way, u);
  return glm::normalize(std::cos(angle) * way +
                        std::sin(angle) * (std::cos(about) * u + std::sin(about) * v));
}

const double kFrom = radians(40.0), kTo = radians(60.0);

// Mean radiance that leaves a layer's far side between both angles, for a beam of one unit per area
// that falls on it straight. Lengths in 1 / scattering.
double simulated(double thickness, double absorption) {
  constexpr int kPhotons = 150'000;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> even(0.0, 1.0);
  double sum = 0.0;
  for (int photon = 0; photon < kPhotons; ++photon) {
    dvec3 way(0.0, 0.0, 1.0);
    double depth = 0.0, travelled = 0.0;
    while (true) {
      const double step = -std::log(1.0 - even(random));
      const double next = depth + step * way.z;
      if (next >= thickness || next < 0.0) {
        travelled += ((next < 0.0 ? 0.0 : thickness) - depth) / way.z;
        const double angle = std::acos(way.z);
        if (next >= thickness && angle > kFrom && angle < kTo) {
          sum += std::exp(-absorption * travelled) / way.z;
        }
        break;
      }
      depth = next;
      travelled += step;
      way = turned(way, angle_turned(even(random)), kTau * even(random));
    }
  }
  return sum / (kPhotons * kTau * (std::cos(kFrom) - std::cos(kTo)));
}

// The same by one turn, with the loss K: the integral of p b exp(-K (source's way + view's way)).
double by_one_turn(double thickness, double absorption) {
  const double loss = absorption + glsl::kScatteringLost;
  constexpr int kSteps = 200;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double c = std::cos(kFrom) + (std::cos(kTo) - std::cos(kFrom)) * (i + 0.5) / kSteps;
    const double longer = loss * (1.0 - c);
    sum += glsl::sea_water_phase(c) * (1.0 - std::exp(-longer * thickness / c)) / longer / kSteps;
  }
  return sum * std::exp(-loss * thickness);
}

TEST(Crest, LightThatIsTurnedMoreThanOnce) {
  for (const double absorption :
       {0.1, 0.34, 1.0}) {  // over the scattering: blue, green, yellow light
    for (const double thickness : {0.5, 1.0, 2.0, 3.0}) {
      const double share = by_one_turn(thickness, absorption) *
                           glsl::crest_turned_again(thickness) / simulated(thickness, absorption);
      EXPECT_NEAR(share, 1.0, 0.12) << "absorption " << absorption << ", thickness " << thickness;
      RecordProperty("share", std::to_string(share));
    }
  }
}

}  // namespace
}  // namespace offing
