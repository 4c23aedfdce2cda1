// Foam: its map (foam_map.h) and its picture. Needs ocean/surface.glsl before it.
#include "lib/water.glsl"
layout(binding = OFFING_UNIT_FOAM) uniform sampler2DArray foam_map;  // thin foam, thick foam
layout(binding = 2) uniform sampler2D foam_pattern;                  // normal, see foam_pattern.h
const float kFoamReach = 0.45;  // of a layer's width
const float kFoamDeviations = 3.2;  // of the pattern, see foam_pattern.cpp
const vec3 kFoamLace = vec3(0.42, 0.72, 0.55);  // weights of patches, lace and bubbles; the sum of squares is 1
const float kFoamEdge = 0.02;  // variance that softens every edge
const vec3 kStreakLines = vec3(0.45, 0.6, 0.5);  // weights of rows and lines, and of lace
const float kStreakLace = 0.43;
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

// Shares of the surface under thin and thick foam at a point of water at rest (relative to the camera),
// over `size` m. Outside the map: the sea's mean.
vec2 sea_foam_share(vec2 q, float size) {
  // A layer is used out to nine tenths of its half width, and where its cells are as small as a pixel.
  float reach = max(max(abs(q.x), abs(q.y)), 20.0 * size);
  // The first that reaches so far, each being four times as wide as the one before, and, toward its rim,
  // the next; after the last the sea's mean.
  float wide = 0.5 * log2(max(reach * ocean.foam_map[0].z / kFoamReach, 1.0e-6));
  float layer = clamp(ceil(wide), 0.0, float(kFoamLayers));
  vec2 share = sea_foam_layer(q, layer);
  float next = smoothstep(-0.16, 0.0, wide - layer);
  for (int i = 0; i < int(next > 0.0); ++i) share = mix(share, sea_foam_layer(q, layer + 1.0), next);
  return share;
}

// Deviations of the pattern from its mean at a place and a factor of it; `fineness`: log2 texels.
float foam_lace(vec2 at, float fineness) {
#ifdef PICK_LEVELS
  fineness = floor(max(fineness, 0.0) + sea_die());
#endif
  return kFoamDeviations * (2.0 * textureLod(foam_pattern, at, fineness).r - 1.0);
}
// What of the pattern's variance is left when 2^fineness of its texels are averaged (fitted, to .04).
vec3 foam_lace_left(vec3 fineness) {
  vec3 f = max(fineness, 0.0);
  return max(1.0 - 0.0306 * f * f, 0.0);
}

// Streaks of old foam along the wind, drawn together by water that sinks between rolls (Langmuir 1938):
// lines of a metre or two that join and part, in rows. An opacity. `lace`: that of the foam.
float foam_streaks(vec2 at, float fineness, float thin, float lace) {
  vec3 lines = vec3(foam_lace(0.125 * at, fineness - 3.0),
                    foam_lace(vec2(0.125 * at.x, 0.625 * at.y + 0.125 * at.x), fineness - 0.7),
                    foam_lace(vec2(0.25 * at.x, 1.75 * at.y - 0.125 * at.x), fineness + 0.8));
  vec3 left = foam_lace_left(fineness + vec3(-3.0, -0.7, 0.8));
  float share = clamp(kStreakShare * ocean.foam_share.w + 0.5 * thin, 0.01, 0.6);
  float unseen = dot(kStreakLines * kStreakLines, vec3(1.0) - left);
  unseen += kStreakLace * kStreakLace * (1.0 - foam_lace_left(vec3(fineness)).x) + 0.05;
  float over = dot(kStreakLines, lines) + kStreakLace * lace - 1.02 * normal_point(share);
  // Faint at the rim.
  return kStreakOpacity * normal_below(over * inversesqrt(unseen)) * clamp(0.35 + over, 0.35, 1.0);
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
  vec2 share = sea_foam_share(q, size);
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
  // Most of the sea has none. (A loop: a CPU renderer runs both sides of an if.)
  for (int i = 0; i < int(max(share.x, ocean.foam_share.w) > 2.0e-3 && fineness < 12.0); ++i) {
    // (Factors are whole eighths: places are known up to eight periods.)
    vec3 lace = vec3(foam_lace(at * vec2(0.375, 0.25), fineness - 2.0),
                     foam_lace(at * vec2(1.5, 1.0), fineness),
                     foam_lace(at.yx * vec2(2.75, 4.5), fineness + 1.4));
    vec3 left = foam_lace_left(fineness + vec3(-2.0, 0.0, 1.4));
    // Where the map does not show waves their crests decide.
    float reach = max(max(abs(q.x), abs(q.y)), 20.0 * size);
    float by_crest = sea_unresolved(reach * ocean.foam_stretch.z);
    vec3 weight = kFoamLace * sqrt(1.0 - 0.85 * by_crest);
    float crest = (1.0 - jacobian) * inversesqrt(max(ocean.foam_share.z, 1.0e-6));
    float sum = dot(weight, lace) + sqrt(0.85 * by_crest) * crest;
    float unseen = dot(weight * weight, vec3(1.0) - left) + 0.85 * by_crest * unresolved + kFoamEdge;
    vec2 point = sqrt(1.0 + kFoamEdge) * vec2(normal_point(clamp(share.x, 1.0e-4, 0.999)),
                                              normal_point(clamp(share.y, 1.0e-4, 0.999)));
    vec2 over = vec2(sum) - point;
    float sharpness = inversesqrt(unseen);
    vec2 cover = vec2(normal_below(over.x * sharpness), normal_below(over.y * sharpness));
    // Foam is thin at its rim and dense within.
    vec2 dense = mix(vec2(0.45), smoothstep(vec2(0.0), vec2(1.1, 0.7), over), 1.0 - min(unseen, 1.0));
    foam.cover = cover.x;
    foam.opacity = mix(cover.x * mix(0.22, 0.85, dense.x), mix(0.75, 1.0, dense.y), cover.y);
    foam.relief = lace.y + lace.z;
    for (int j = 0; j < int(ocean.foam_share.w > 0.0); ++j) {
      float streaks = foam_streaks(at, fineness, plume, 0.7 * (lace.y + lace.z));
      foam.opacity = mix(foam.opacity, 1.0, streaks * (1.0 - foam.cover));
    }
  }
  foam.opacity = clamp(foam.opacity, 0.0, 1.0);
  return foam;
}
