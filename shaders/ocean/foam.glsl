// Reading the foam map (foam_map.h). Needs ocean/surface.glsl before it.
layout(binding = OFFING_UNIT_FOAM) uniform sampler2DArray foam_map;  // thin foam, thick foam
layout(binding = 2) uniform sampler2D foam_pattern;                  // evenly distributed over 0 … 1
const float kFoamReach = 0.45;  // of a layer's width
const vec3 kFoamLace = vec3(0.45, 0.8, 0.6);
const float kFoamEven = 1.702 * 3.4641016;  // over the deviation of an even distribution

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

// The pattern at a place and a factor of it, less its mean; `fineness`: log2 texels of the pattern itself.
float foam_lace(vec2 at, float fineness) {
#ifdef PICK_LEVELS
  fineness = floor(max(fineness, 0.0) + sea_die());
#endif
  return textureLod(foam_pattern, at, fineness).r - 0.5;
}

// What a pixel of this size (m) sees of it, as an opacity: bubbles and holes near by, torn patches farther
// out, the mean at last.
float sea_foam(vec2 q, float size) {
  vec2 share = sea_foam_share(q, size);
  share.x = max(share.x, share.y);  // thick foam covers as well
  // From force 7 on old foam lies in streaks, which the observed share of whitecaps does not count: a wide
  // veil with half of its own opacity.
  float veil = 1.0 + 2.5 * ocean.foam_share.w;
  float thinness = 1.0 / (1.0 + 0.9 * ocean.foam_share.w);
  share.x = min(share.x * veil, 1.0);
  vec2 along = ocean.foam_grid.zw;
  float fineness = log2(max(size * length(along) * ocean.foam_stretch.y, 1.0e-6));
  float far = smoothstep(4.5, 7.5, fineness);
  vec2 weight = vec2(0.55 * thinness, 0.45);
  float opacity = dot(share, weight);
  // Most of the sea has none. (A loop: a CPU renderer runs both sides of an if.)
  for (int i = 0; i < int(share.x > 4.0e-3 && far < 1.0); ++i) {
    vec2 at = ocean.foam_grid.xy + vec2(dot(along, q), ocean.foam_stretch.x *
              (along.x * q.y - along.y * q.x));
    // Patches, lace and bubbles. (Factors are whole eighths: places are known up to eight periods.)
    vec3 lace = vec3(foam_lace(0.125 * at, fineness - 3.0), foam_lace(at, fineness),
                     foam_lace(2.75 * at.yx, fineness + 1.4));
    // Their sum, of those that are not too fine to be seen, is all but normal: made even again by the
    // logistic curve.
    vec3 weights = kFoamLace * clamp((vec3(8.0, 5.0, 3.6) - fineness) / 3.0, 0.05, 1.0);
    float even = 1.0 / (1.0 + exp(-kFoamEven * dot(lace, weights) * inversesqrt(dot(weights, weights))));
    vec2 softness = min(vec2(0.22, 0.15), 0.7 * share);
    vec2 edge = vec2(1.0) - share;
    vec2 near = smoothstep(edge - softness, edge + softness + 1.0e-4, vec2(even));
    // Bubbles let water through.
    near.x *= 1.0 + 1.2 * lace.z;
    opacity = mix(dot(near, weight), opacity, far);
  }
  return clamp(opacity, 0.0, 1.0);
}
