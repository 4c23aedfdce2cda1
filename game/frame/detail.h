#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "game/frame/rigid_vertex.h"

namespace offing {

/// Indices of one draw.
struct IndexRange {
  std::uint32_t first = 0, count = 0;
};

/// How far (m) the surface of each level may lie from the finest one's.
inline constexpr std::array<float, 5> kDetailErrors = {0.0f, 0.003f, 0.008f, 0.02f, 0.05f};

/// The same surface at each of kDetailErrors, from the same vertices.
using DetailLevels = std::array<IndexRange, kDetailErrors.size()>;

/// Adds coarser copies of the last `count` indices of a mesh behind them (Garland & Heckbert 1997,
/// "Surface simplification using quadric error metrics", by meshoptimizer).
DetailLevels add_detail_levels(std::span<const RigidVertex> vertices,
                               std::vector<std::uint32_t>& indices, std::uint32_t first);

/// The coarsest level whose error stays under half a pixel, for a thing that is nowhere closer than
/// `distance` (m) where a pixel at 1 m is `pixel` (m) high.
int detail_level(float distance, float pixel);

}  // namespace offing
