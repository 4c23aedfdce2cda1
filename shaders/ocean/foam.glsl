// Reading the foam map (foam_map.h). Needs ocean/surface.glsl before it.
layout(binding = OFFING_UNIT_FOAM) uniform sampler2DArray foam_map;  // thin foam, thick foam
layout(binding = 2) uniform sampler2D foam_pattern;                  // evenly distributed over 0 … 1

// Shares of the surface under thin and thick foam at a point of water at rest (relative to the camera),
// over `size` m. Outside the map: the sea's mean.
vec2 sea_foam_share(vec2 q, float size) {
  // A layer is used out to nine tenths of its half width, and where its cells are as small as a pixel.
  float reach = max(max(abs(q.x), abs(q.y)), 40.0 * size);
  vec2 share = vec2(0.0);
  float left = 1.0;
  for (int layer = 0; layer < kFoamLayers; ++layer) {
    float inside = 1.0 - smoothstep(0.36, 0.45, reach * ocean.foam_map[layer].z);
    if (inside <= 0.0) continue;
    vec3 place = vec3(ocean.foam_map[layer].xy + q * ocean.foam_map[layer].z, float(layer));
    share += left * inside * textureLod(foam_map, place, 0.0).xy;
    left *= 1.0 - inside;
    if (left <= 0.0) break;
  }
  return share + left * ocean.foam_share.x * vec2(1.0, 0.15);
}

// What a pixel of this size (m) sees of it, as an opacity: bubbles and holes near by, the mean far away.
float sea_foam(vec2 q, float size) {
  vec2 share = sea_foam_share(q, size);
  share.x = max(share.x, share.y);  // thick foam covers as well
  vec2 along = ocean.foam_grid.zw;
  vec2 at = ocean.foam_grid.xy + vec2(dot(along, q), ocean.foam_stretch.x *
            (along.x * q.y - along.y * q.x));
  float fineness = log2(max(size * length(along) * ocean.foam_stretch.y, 1.0e-6));
  // (Factors are whole eighths: places are known up to eight periods of the pattern.)
  float pattern = 0.5 * (textureLod(foam_pattern, at, fineness).r +
                         textureLod(foam_pattern, 2.75 * at.yx, fineness + 1.4).r);
  // The mean of two even distributions is triangular: even it out again.
  pattern = pattern < 0.5 ? 2.0 * pattern * pattern : 1.0 - 2.0 * (1.0 - pattern) * (1.0 - pattern);
  // A thin veil, and inside it the thick white of what breaks now.
  vec2 softness = min(vec2(0.15), 0.5 * share);
  vec2 edge = vec2(1.0) - share;
  vec2 near = smoothstep(edge - softness, edge + softness + 1.0e-4, vec2(pattern));
  vec2 layers = mix(near, share, smoothstep(1.5, 4.5, fineness));
  return clamp(dot(layers, vec2(0.55, 0.45)), 0.0, 1.0);
}
