// Where the sea's maps are read: by the mesh, by the foam and by the picture of it.
#include "shared/bindings.h"

#ifdef FLAT_OCEAN  // in the picture of the sea: see surface.vert
layout(location = 5) flat in OceanData ocean;
#else
layout(std140, binding = OFFING_BIND_OCEAN) uniform OceanBlock { OceanData ocean; };
#endif
layout(binding = 0) uniform sampler2DArray sea_displacement;  // Dx, h, Dz, Dxz
layout(binding = 1) uniform sampler2DArray sea_slopes;        // sx, sz, Dxx, Dzz
// What the maps do not show, by the logarithm of the size over which they are read: covariance of the
// slopes xx, zz, xz; share of the breaking waves' variance (roughness_table.h).
layout(binding = OFFING_UNIT_SEA_ROUGHNESS) uniform sampler2D sea_roughness;

const float kTwiceEarthRadius = 2.0 * 6371.0e3;  // m
const float kFadeFirst = 4.0;  // what a cascade still shows of its waves at this map level …
const float kFadeLast = 5.5;   // … is gone at this one, and need not be read

// Place in the maps of a cascade of a point q (x, z in m, relative to the camera, at rest).
vec3 sea_map_place(int cascade, vec2 q) {
  vec2 g = ocean.grid[cascade].xy;
  return vec3(ocean.origin[cascade].xy + vec2(g.x * q.x + g.y * q.y, g.x * q.y - g.y * q.x),
              float(cascade));
}

// Map level at which details smaller than 2^size (m) are averaged away.
float sea_map_level_log2(int cascade, float size) { return max(size - ocean.grid[cascade].z, 0.0); }
float sea_map_level(int cascade, float size) { return sea_map_level_log2(cascade, log2(size)); }
float sea_map_share(float level) { return 1.0 - smoothstep(kFadeFirst, kFadeLast, level); }

// One of the two map levels on either side of `level`, by chance in proportion: the mean over pixels is
// what reading both would give, at half the cost. `die`: even over 0 … 1.
float sea_map_level_picked(float level, float die) {
  return min(floor(level + die), float(kOceanMapLevels - 1));
}

float sea_missing_entry(float size_log2) { return (size_log2 - kRoughnessFirst) * kRoughnessSteps; }
vec4 sea_missing(float size_log2) {
  float entry = sea_missing_entry(size_log2);
  return textureLod(sea_roughness, vec2((entry + 0.5) / float(kRoughnessEntries), 0.5), 0.0);
}
// The same from one entry, by chance; `die`: even over 0 … 1.
vec4 sea_missing_picked(float size_log2, float die) {
  int entry = int(max(sea_missing_entry(size_log2) + die, 0.0));
  return texelFetch(sea_roughness, ivec2(min(entry, kRoughnessEntries - 1), 0), 0);
}
// Share of the variance of the breaking waves' Jacobian that is lost over this size (m).
float sea_unresolved(float size) { return sea_missing(log2(size)).w; }
