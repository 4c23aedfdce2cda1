// How foam's patterns are put together: painted by C++ (foam_pattern.h), read by ocean/foam.glsl.
#ifdef __cplusplus
#pragma once
namespace offing::shared {
#endif

// Of the pictures, across, and what they cover, in units of the foam's grid (OceanData::foam_grid).
const int kFoamTexels = 1024;
const float kFoamLacePeriod = 2.0f, kFoamRowsPeriod = 8.0f;
// Weights of torn patches, lace and bubbles; the sum of squares is 1.
const float kFoamPatches = 0.42f, kFoamLace = 0.72f, kFoamBubbles = 0.55f;
// Weights of streaks in rows, of lines, of finer ones and of lace; the sum of squares is 1.
const float kStreakRows = 0.45f, kStreakLines = 0.6f, kStreakThreads = 0.5f, kStreakLace = 0.43f;

#ifdef __cplusplus
}  // namespace offing::shared
#endif
