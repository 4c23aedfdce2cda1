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
  vec4 grid[kOceanMaxCascades];    // x: c, y: s (1/m); z: log2 of a map point's size in m; w: unused
  vec4 origin[kOceanMaxCascades];  // x, y: uv of the point below the camera
  // Slope covariance that level l of cascade c still shows, at [c * kOceanMapLevels + l]:
  // x: <sx sx>, y: <sz sz>, z: <sx sz>; w: their trace.
  vec4 resolved[kOceanMaxCascades * kOceanMapLevels];
  vec4 variance;   // slope covariance of the whole sea down to capillaries, same order
  vec4 foam;       // x: Jacobian below which the sea breaks; y: choppiness^2; z: resolved trace of all
                   // cascades at level 0; w: share of the sea that is white
  vec4 foam_grid;  // x, y: foam texture coordinates of the point below the camera; z: 1/length
  vec4 water;      // x: Hs (m); y: number of cascades; z: mesh: distance per spacing; w: finest spacing (m)
};

#ifdef __cplusplus
}  // namespace offing::shared
#endif
