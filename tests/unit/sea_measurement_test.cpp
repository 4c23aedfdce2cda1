#include "engine/ocean/sea_measurement.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/angles.h"

namespace offing {
namespace {

// One cascade of 64² points over 100 m on deep water.
Cascade flat_cascade() {
  Cascade cascade;
  cascade.size = 64;
  cascade.band.length = 100.0;
  for (int z = 0; z < 64; ++z) {
    for (int x = 0; x < 64; ++x) {
      const double nx = x < 32 ? x : x - 64, nz = z < 32 ? z : z - 64;
      cascade.frequency.push_back(std::sqrt(kGravity * kTau / 100.0 * std::hypot(nx, nz)));
    }
  }
  return cascade;
}

TEST(SeaMeasurement, FindsTheHeightAndPeriodOfATrainOfWaves) {
  const Cascade cascade = flat_cascade();
  for (const int waves : {2, 5, 11}) {
    std::vector<float> maps;
    for (int i = 0; i < 64 * 64; ++i) {
      const double height = 0.3 + 1.5 * std::cos(kTau * waves * (i % 64) / 64.0);
      maps.insert(maps.end(), {9.0f, static_cast<float>(height), -7.0f, 3.0f});
    }
    const SeaMeasurement sea = measure_sea({&cascade, 1}, maps);
    const double frequency = std::sqrt(kGravity * kTau / 100.0 * waves);
    EXPECT_NEAR(sea.m0, 0.5 * 1.5 * 1.5, 1e-6);
    EXPECT_NEAR(sea.hs, 4.0 * 1.5 / std::sqrt(2.0), 1e-6);
    EXPECT_NEAR(kTau / sea.tp, frequency, 0.02) << "half a bin";
  }
}

TEST(SeaMeasurement, AFlatSeaHasNoPeriod) {
  const Cascade cascade = flat_cascade();
  const SeaMeasurement sea = measure_sea({&cascade, 1}, std::vector<float>(64 * 64 * 4, 0.0f));
  EXPECT_EQ(sea.hs, 0.0);
  EXPECT_EQ(sea.tp, 0.0);
}

}  // namespace
}  // namespace offing
