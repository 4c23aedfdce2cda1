// Which texels of the probe's map a work group makes: a square of 8 x 8 of one of its levels, listed by
// ProbePlan (engine/sky/probe_plan.h). One dispatch makes any run of tiles, over the ends of levels.
#include "shared/bindings.h"
#include "shared/probe.h"

layout(std140, binding = OFFING_BIND_PROBE) uniform ProbeBlock { ProbeData probe; };
layout(std430, binding = 1) readonly buffer Tiles { uvec4 tiles[]; };
layout(location = 0) uniform int first_tile;

struct ProbeTile {
  int level;
  ivec2 origin;  // first texel of the level in the map
  int side;      // texels per side of the level's two squares
  ivec2 corner;  // first texel of the tile in its square
  bool below;    // the square is that of the lower half of the sphere
  ivec2 list;    // of nodes, in fours: the first, how many
};

ProbeTile this_tile() {
  uvec4 packed_tile = tiles[first_tile + int(gl_WorkGroupID.x)];
  ProbeTile tile;
  tile.level = int(packed_tile.z);
  tile.origin = ivec2(probe.levels[tile.level].xy);
  tile.side = int(probe.levels[tile.level].z);
  tile.corner = ivec2(packed_tile.w & 4095u, (packed_tile.w >> 12) & 4095u);
  tile.below = packed_tile.w >> 24 != 0u;
  tile.list = ivec2(packed_tile.xy);
  return tile;
}
