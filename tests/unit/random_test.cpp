#include "engine/core/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace offing {
namespace {

constexpr int kSamples = 100'000;
// Every sample mean below is off by less than this many of its own standard deviations: a fair
// generator fails one such check in some 1.7 million (5 sigma, two-sided).
constexpr double kSigmas = 5.0;

TEST(Random, SplitMixMatchesItsPublishedOutput) {
  // The first output of SplitMix64 seeded with 0, mixed thrice as random_bits chains it: with
  // stream and index equal to the inner values each step is mix(0) = 0xe220a8397b1dcdaf.
  const std::uint64_t first = 0xe220a8397b1dcdafull;
  EXPECT_EQ(random_bits(0, first, first), first);
}

TEST(Random, UniformHasItsMoments) {
  double mean = 0.0, square = 0.0, least = 1.0, most = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    const double u = random_uniform(1, 2, i);
    mean += u;
    square += u * u;
    least = std::min(least, u);
    most = std::max(most, u);
  }
  mean /= kSamples;
  square /= kSamples;
  EXPECT_NEAR(mean, 0.5, kSigmas * std::sqrt(1.0 / 12.0 / kSamples));
  EXPECT_NEAR(square, 1.0 / 3.0, kSigmas * std::sqrt(4.0 / 45.0 / kSamples));
  EXPECT_GE(least, 0.0);
  EXPECT_LT(most, 1.0);
}

TEST(Random, UniformFillsItsBinsEvenly) {
  constexpr int kBins = 64;
  std::vector<int> bins(kBins);
  for (int i = 0; i < kSamples; ++i) ++bins[static_cast<int>(random_uniform(3, 4, i) * kBins)];
  double chi_square = 0.0;
  const double expected = static_cast<double>(kSamples) / kBins;
  for (const int count : bins) chi_square += (count - expected) * (count - expected) / expected;
  // 63 degrees of freedom: mean 63, standard deviation sqrt(126).
  EXPECT_NEAR(chi_square, kBins - 1, kSigmas * std::sqrt(2.0 * (kBins - 1)));
}

TEST(Random, NormalPairsHaveTheirMoments) {
  double mean = 0.0, square = 0.0, cube = 0.0, fourth = 0.0, product = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    const glm::dvec2 pair = random_normal_pair(5, 6, i);
    for (const double x : {pair.x, pair.y}) {
      ASSERT_TRUE(std::isfinite(x));
      mean += x;
      square += x * x;
      cube += x * x * x;
      fourth += x * x * x * x;
    }
    product += pair.x * pair.y;
  }
  const double n = 2.0 * kSamples;
  // Variances of x, x^2, x^3, x^4 of a standard normal: 1, 2, 15, 96.
  EXPECT_NEAR(mean / n, 0.0, kSigmas * std::sqrt(1.0 / n));
  EXPECT_NEAR(square / n, 1.0, kSigmas * std::sqrt(2.0 / n));
  EXPECT_NEAR(cube / n, 0.0, kSigmas * std::sqrt(15.0 / n));
  EXPECT_NEAR(fourth / n, 3.0, kSigmas * std::sqrt(96.0 / n));
  EXPECT_NEAR(product / kSamples, 0.0, kSigmas * std::sqrt(1.0 / kSamples));
}

// Correlation of u - 1/2 with v - 1/2 over all samples; its standard deviation is 1/sqrt(samples).
template <class U, class V>
double correlation(U&& u, V&& v) {
  double sum = 0.0;
  for (int i = 0; i < kSamples; ++i) sum += (u(i) - 0.5) * (v(i) - 0.5);
  return sum * 12.0 / kSamples;
}

TEST(Random, NeighboursAreIndependent) {
  const double limit = kSigmas / std::sqrt(kSamples);
  const auto value = [](int i) { return random_uniform(7, 8, i); };
  EXPECT_NEAR(correlation(value, [](int i) { return random_uniform(7, 8, i + 1); }), 0.0, limit);
  EXPECT_NEAR(correlation(value, [](int i) { return random_uniform(7, 9, i); }), 0.0, limit);
  EXPECT_NEAR(correlation(value, [](int i) { return random_uniform(8, 8, i); }), 0.0, limit);
  EXPECT_NEAR(correlation([](int i) { return random_uniform(7, i, 0); },
                          [](int i) { return random_uniform(7, i + 1, 0); }),
              0.0, limit);
  EXPECT_NEAR(correlation([](int i) { return random_uniform(i, 0, 0); },
                          [](int i) { return random_uniform(i + 1, 0, 0); }),
              0.0, limit);
}

TEST(Random, ValuesDoNotDependOnTheOrder) {
  std::vector<double> forward, backward;
  for (int i = 0; i < 100; ++i) forward.push_back(random_normal_pair(1, 2, i).x);
  for (int i = 99; i >= 0; --i) backward.push_back(random_normal_pair(1, 2, i).x);
  std::reverse(backward.begin(), backward.end());
  EXPECT_EQ(forward, backward);
}

TEST(Random, NearCountersDoNotCollide) {
  std::set<std::uint64_t> seen;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (std::uint64_t stream = 0; stream < 20; ++stream) {
      for (std::uint64_t index = 0; index < 20; ++index) {
        seen.insert(random_bits(seed, stream, index));
      }
    }
  }
  EXPECT_EQ(seen.size(), 8000u);
}

TEST(Random, HashIsFnv1a) {
  // Test vectors of the FNV authors (64 bit, FNV-1a).
  EXPECT_EQ(hash_bytes("", 0), 0xcbf29ce484222325ull);
  EXPECT_EQ(hash_bytes("a", 1), 0xaf63dc4c8601ec8cull);
  EXPECT_EQ(hash_bytes("foobar", 6), 0x85944171f73967e8ull);
  EXPECT_EQ(hash_bytes("bar", 3, hash_bytes("foo", 3)), hash_bytes("foobar", 6));
  EXPECT_NE(hash_of(1, 2), hash_of(2, 1));
}

}  // namespace
}  // namespace offing
