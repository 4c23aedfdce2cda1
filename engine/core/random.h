#pragma once
#include <glm/vec2.hpp>

#include <cstdint>

namespace offing {

/// A counter-based generator: the value depends only on (seed, stream, index), never on the order
/// in which values are asked for, so a sea is the same at every resolution and on every machine.
/// The mixing function is SplitMix64 (Steele, Lea & Flood 2014).
std::uint64_t random_bits(std::uint64_t seed, std::uint64_t stream, std::uint64_t index);

/// Uniform in [0, 1).
double random_uniform(std::uint64_t seed, std::uint64_t stream, std::uint64_t index);

/// Two independent standard normal values (Box-Muller).
glm::dvec2 random_normal_pair(std::uint64_t seed, std::uint64_t stream, std::uint64_t index);

/// FNV-1a over bytes, for keys; start with the default and chain.
std::uint64_t hash_bytes(const void* data, std::size_t size,
                         std::uint64_t hash = 14695981039346656037ull);

/// Hash of trivially copyable values without padding, chained in order.
template <class... Values>
std::uint64_t hash_of(const Values&... values) {
  std::uint64_t hash = 14695981039346656037ull;
  ((hash = hash_bytes(&values, sizeof(values), hash)), ...);
  return hash;
}

}  // namespace offing
