// Foam: its map (foam_map.h) and its picture. Needs ocean/surface.glsl before it.
#include "lib/water.glsl"
#include "shared/foam.h"
layout(binding = OFFING_UNIT_FOAM) uniform sampler2DArray foam_map;  // thin foam, thick foam
layout(binding = OFFING_UNIT_FOAM_LACE) uniform sampler2D foam_lace_picture;  // see foam_pattern.h
layout(binding = OFFING_UNIT_FOAM_ROWS) uniform sampler2D foam_rows_picture;
const float kFoamReach = 0.45;  // of a layer's width
const float kFoamEdge = 0.02;  // variance that softens every edge
const float kStreakShare = 0.28, kStreakOpacity = 0.45;

vec2 sea_foam_layer(vec2 q, float layer) {
  float known = min(layer, float(kFoamLayers - 1));
  // From the widest layer, whose width is a power of four times theirs. (Not by index: a CPU renderer reads
  // an array that pixels index each for itself one by one.)
  const int kWidest = kFoamLayers - 1;
  vec2 at = exp2(2.0 * (float(kWidest) - known)) *
            (ocean.foam_map[kWidest].xy + q * ocean.foam_map[kWidest].z);
  vec2 share = textureLod(foam_map, vec3(at, known), 0.0).xy;
  return layer < float(kFoamLayers) ? share : ocean.foam_share.x * vec2(1.0, 0.15);
}

// The layer that is used at a place, as a number that grows evenly with the logarithm of the distance: each
// is used out to nine tenths of its half width, and where its cells are as small as a pixel.
float sea_foam_wide(vec2 q, float size) {
  float reach = max(max(abs(q.x), abs(q.y)), 20.0 * size);
  return 0.5 * log2(max(reach * ocean.foam_map[0].z / kFoamReach, 1.0e-6));
}

// Shares of the surface under thin and thick foam at a point of water at rest (relative to the camera).
// Outside the map: the sea's mean.
vec2 sea_foam_share(vec2 q, float wide) {
  // The first that reaches so far, each being four times as wide as the one before, and, toward its rim,
  // the next; after the last the sea's mean.
  float layer = clamp(ceil(wide), 0.0, float(kFoamLayers));
  float next = smoothstep(-0.16, 0.0, wide - layer);
#ifdef PICK_LEVELS
  return sea_foam_layer(q, next > sea_die() ? layer + 1.0 : layer);
#else
  return mix(sea_foam_layer(q, layer), sea_foam_layer(q, layer + 1.0), next);
#endif
}

// Values of a picture at a place in the foam's grid; `fineness`: log2 of the pixel in 1/256 of its unit.
vec2 foam_picture(sampler2D picture, float period, vec2 at, float fineness) {
  fineness += log2(float(kFoamTexels) / 256.0 / period);
#ifdef PICK_LEVELS
  fineness = floor(max(fineness, 0.0) + sea_die());
#endif
  return textureLod(picture, at / period, fineness).rg;
}
// What of a pattern's variance is left when 2^fineness of its texels are averaged (fitted, to .04).
vec3 foam_pattern_left(vec3 fineness) {
  vec3 f = max(fineness, 0.0);
  return max(1.0 - 0.0306 * f * f, 0.0);
}

// Streaks of old foam along the wind, drawn together by water that sinks between rolls (Langmuir 1938):
// lines of a metre or two that join and part, in rows. An opacity. `pattern`: deviations; `left`: what of
// its lace's variance the pixel shows.
float foam_streaks(float pattern, float fineness, float thin, float left) {
  const vec3 kWeights = vec3(kStreakRows * kStreakRows, kStreakLines * kStreakLines,
                             kStreakThreads * kStreakThreads);
  float force = ocean.foam_share.w;
  float share = clamp(kStreakShare * force + 0.5 * thin * min(1.5 * force, 1.0), 0.01, 0.6);
  float unseen = dot(kWeights, vec3(1.0) - foam_pattern_left(fineness + vec3(-3.0, -1.3, -0.2)));
  unseen += kStreakLace * kStreakLace * (1.0 - left) + 0.05;
  float over = pattern - 1.02 * normal_point(share);
  // They come by and by: single bubbles at first, which only their density makes white. Old foam is thin
  // but for the middle of a streak.
  float dense = force * (0.2 + 0.8 * smoothstep(0.0, 1.4, over));
  return kStreakOpacity * dense * normal_below(over * inversesqrt(unseen));
}

// What a pixel sees of foam.
struct Foam {
  float cover;    // share of the pixel under whitecaps, thin or thick
  float opacity;  // how white it is, streaks included
  float plume;    // share of the water that has broken of late and is full of bubbles
  float relief;   // deviations of the lace: high where foam is piled up
};

// Foam of water at rest at `q` in a pixel of `size` m that shows this Jacobian of the breaking waves, and
// not the share `unresolved` of its variance.
//
// A share of white becomes a picture by a sum of patterns, each normal with variance 1 over the whole
// sea: torn patches, lace and bubbles and, where the map's cells are wider than waves, the Jacobian
// itself, so that foam lies on crests. White is what exceeds the point above which the normal
// distribution has that share. What of the sum a pixel cannot show softens the edge by just so much that
// the mean stays the share, at any distance.
Foam sea_foam(vec2 q, float size, float jacobian, float unresolved) {
  float wide = sea_foam_wide(q, size);
  vec2 share = sea_foam_share(q, wide);
  float plume = share.x;
  // What breaks in this moment is known pixel by pixel.
  float fresh = normal_below((ocean.foam.x - jacobian) *
                             inversesqrt(ocean.foam_share.z * unresolved + ocean.foam.w));
  share.y = max(share.y, fresh);
  share.x = max(share.x, share.y);  // thick foam covers as well
  Foam foam = Foam(share.x, dot(share, vec2(0.5, 0.4)), plume, 0.0);
  vec2 along = ocean.foam_grid.zw;
  vec2 at = ocean.foam_grid.xy + vec2(dot(along, q), ocean.foam_stretch.x *
            (along.x * q.y - along.y * q.x));
  float fineness = log2(max(size * length(along) * ocean.foam_stretch.y, 1.0e-6));
  // Most of the sea has none.
  if (max(share.x, ocean.foam_share.w) > 2.0e-3 && fineness < 12.0) {
    float lace = foam_picture(foam_lace_picture, kFoamLacePeriod, at, fineness).r;
    vec2 rows = foam_picture(foam_rows_picture, kFoamRowsPeriod, at, fineness);
    vec3 left = foam_pattern_left(fineness + vec3(-1.7, 0.3, 1.9));
    // Where the map does not show waves their crests decide.
    vec4 passed = clamp(vec4(wide) - vec4(0.0, 1.0, 2.0, 3.0), 0.0, 1.0);
    float by_crest = 0.85 * (ocean.foam_stretch.z + dot(ocean.foam_crest, passed));
    float crest = (1.0 - jacobian) * inversesqrt(max(ocean.foam_share.z, 1.0e-6));
    float sum = sqrt(1.0 - by_crest) * (kFoamPatches * rows.r + lace) + sqrt(by_crest) * crest;
    const vec3 kWeights = vec3(kFoamPatches * kFoamPatches, kFoamLace * kFoamLace,
                               kFoamBubbles * kFoamBubbles);
    float unseen = (1.0 - by_crest) * dot(kWeights, vec3(1.0) - left) + by_crest * unresolved + kFoamEdge;
    vec2 point = sqrt(1.0 + kFoamEdge) * vec2(normal_point(clamp(share.x, 1.0e-4, 0.999)),
                                              normal_point(clamp(share.y, 1.0e-4, 0.999)));
    vec2 over = vec2(sum) - point;
    float sharpness = inversesqrt(unseen);
    vec2 cover = vec2(normal_below(over.x * sharpness), normal_below(over.y * sharpness));
    // Foam is thin at its rim and dense within.
    vec2 dense = mix(vec2(0.45), smoothstep(vec2(0.0), vec2(1.1, 0.7), over), 1.0 - min(unseen, 1.0));
    foam.cover = cover.x;
    foam.opacity = mix(cover.x * mix(0.22, 0.85, dense.x), mix(0.75, 1.0, dense.y), cover.y);
    foam.relief = 1.56 * lace;
#ifdef STREAKS
    float streaks = foam_streaks(rows.g + 0.47 * lace, fineness, plume, left.y);
    foam.opacity = mix(foam.opacity, 1.0, streaks * (1.0 - foam.cover));
#endif
  }
  foam.opacity = clamp(foam.opacity, 0.0, 1.0);
  return foam;
}
