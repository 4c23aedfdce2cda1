// What the ocean's shaders share with C++ (std140: vec4 only).
#ifdef __cplusplus
#pragma once
#include <glm/vec4.hpp>
namespace offing::shared {
using glm::vec4;
#endif

const int kOceanMaxCascades = 5;
const int kOceanMapLevels = 6;  // levels of the maps: 0 to 5

struct OceanData {
  // Per cascade. Map coordinates of a point: uv = origin.xy + (c x + s z, c z - s x), with x and z
  // relative to the camera and (c, s) = grid.xy = (cos, sin)(angle) / length.
  vec4 grid[kOceanMaxCascades];    // x: c, y: s (1/m); z: log2 of a map point's size in m; w: 1 where its waves
                                   // are long enough to break
  vec4 origin[kOceanMaxCascades];  // x, y: uv of the point below the camera
  // Slope covariance that level l of cascade c still shows, at [c * kOceanMapLevels + l]:
  // x: <sx sx>, y: <sz sz>, z: <sx sz>; w: their trace.
  vec4 resolved[kOceanMaxCascades * kOceanMapLevels];
  vec4 variance;   // slope covariance of the whole sea down to capillaries, same order
  vec4 foam;       // x: Jacobian at which half the water is white; y: choppiness^2; z: trace that all
                   // cascades show at level 0; w: variance by which that edge is softened
  // Foam texture coordinates: foam_grid.xy + (along . q, stretch (along x q)), along = foam_grid.zw.
  vec4 foam_grid;     // x, y: of the point below the camera; z, w: unit along the wind / length
  vec4 foam_stretch;  // x: length along over length across; y: that times texels per length
  vec4 water;      // x: Hs (m); y: number of cascades; z: mesh: distance per spacing; w: finest spacing (m)
};

#ifdef __cplusplus
}  // namespace offing::shared
#endif
