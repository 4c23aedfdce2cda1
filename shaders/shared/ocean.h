// What the ocean's shaders share with C++ (std140: vec4 only).
#ifdef __cplusplus
#pragma once
#include <glm/vec4.hpp>
namespace offing::shared {
using glm::vec4;
#endif

const int kOceanMaxCascades = 5;
const int kOceanMapLevels = 6;  // levels of the maps: 0 to 5
// The foam map's layers: squares about the viewer, each four times as wide as the one inside it.
const int kFoamLayers = 4;
// Ripples finer than the finest cascade are its picture at this scale.
const float kRippleScale = 0.1763f;
const int kGustTexels = 512;     // of the gust field, across
const int kHorizonTexels = 256;  // of the strip of the horizon's light
// Where the roughness table begins and how finely it goes on: entries per doubling of the size.
const float kRoughnessFirst = -6.0f;  // log2 m
const float kRoughnessSteps = 8.0f;
const int kRoughnessEntries = 128;

struct OceanData {
  // Per cascade. Map coordinates of a point: uv = origin.xy + (c x + s z, c z - s x), with x and z
  // relative to the camera and (c, s) = grid.xy = (cos, sin)(angle) / length.
  vec4 grid[kOceanMaxCascades];    // x: c, y: s (1/m); z: log2 of a map point's size in m;
                                   // w: of the finest: slope of ripples over its own
  vec4 origin[kOceanMaxCascades];  // x, y: uv of the point below the camera; z, w: that of its ripples
  vec4 water;      // x: Hs (m); y: number of cascades; z: mesh: distance per spacing; w: finest spacing (m)
  // Cascades are sorted by length: the first foam.z of them have waves long enough to break.
  vec4 foam;       // x: Jacobian at which half the water turns white; y: at which it may be white already;
                   // z: number of breaking cascades; w: variance by which the edges are softened
  vec4 foam_share; // x: share of white; y: that over what is breaking now; z: variance of the
                   // breaking waves' Jacobian; w: streaks, 0 to 1
  vec4 foam_map[kFoamLayers];  // x, y: uv of the point below the camera; z: 1 / width (1/m)
  // Foam texture coordinates: foam_grid.xy + (along . q, stretch (along x q)), along = foam_grid.zw.
  vec4 foam_grid;     // x, y: of the point below the camera; z, w: unit along the wind / length
  vec4 foam_stretch;  // x: length along over length across; y: that times 256;
                      // z: what the foam map's finest cells leave out of the breaking waves' variance
  vec4 foam_crest;    // what each coarser layer leaves out more of it
  vec4 gust;          // x, y: uv of the point below the camera; z: 1 / period (1/m); w: deviation / mean
  vec4 squall;        // x, y: uv of the point below the camera; z: 1 / period (1/m); w: 1 where there are any
  // Water by linear RGB.
  vec4 body;          // rgb: radiance of the depths over the illuminance that falls on them
  vec4 plume;         // rgb: light left by 1.2 m of it
  vec4 crest_loss;    // rgb: K, what light loses on its way through a crest (1/m); w: what is scattered of green
  vec4 crest_gain;    // rgb: b / (2 K n^2)
  vec4 hull_loss;     // rgb: what light from a hull under the surface loses (1/m)
};

#ifdef __cplusplus
// Besides five of its own the picture's vertex shader may hand on 27 vectors (surface.vert).
static_assert(sizeof(OceanData) <= 27 * 16);
#endif

// One step of the foam map.
struct FoamData {
  vec4 cell[kFoamLayers];   // x: size (m); y: its log2; z, w: where the camera's cell begins, from the camera (m)
  vec4 place[kFoamLayers];  // x, y: the camera's cell in the map; z, w: cells gone since these rows were last seen to
  vec4 step;                // x: time since then (s); y: first row; z: rows from one to the next
};

#ifdef __cplusplus
}  // namespace offing::shared
#endif
