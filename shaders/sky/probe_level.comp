// A level of the probe: for each direction n the mean of what is seen, weighed by how much the facets about
// n mirror of it (GGX seen along n, Karis 2013): a sum over the nodes that the plan lists for its tile
// (engine/sky/probe_plan.h). No samples, and so no noise.
//
// Light from l is mirrored by the facets half way, whose slope is the tangent of half the angle between n
// and l. That is l's stereographic image: a node's disc is a disc of slopes. And GGX's distribution of
// slopes over the width alpha is the stereographic image of an even sphere, so that the share of the
// facets in a disc is that of a cap of that sphere, (1 - cos) / 2: exact for nodes wider than the lobe as
// for narrow ones. With c = n.l, the node's solid angle W and T = 4 alpha^2 W / pi it is
// T / (2 R (R + A)), A = alpha^2 (1 + c) + 1 - c - W / (2 pi), R = sqrt(A^2 + T).
#include "sky/probe_tile.glsl"
#include "lib/probe.glsl"

layout(local_size_x = 8) in;
layout(rgba16f, binding = 0) uniform writeonly image2D map;
layout(binding = 0) uniform sampler2D places;  // of nodes: see ProbePlan
layout(binding = 1) uniform sampler2D seen;    // of nodes: radiance over the sky's level illuminance
layout(binding = 2) uniform usampler2D lists;  // four nodes a texel

const int kRows = 8;  // of the tile: a node once read serves them all

void main() {
  ProbeTile tile = this_tile();
  int column = min(tile.corner.x + int(gl_LocalInvocationID.x), tile.side - 1), row = tile.corner.y;
  vec3 n[kRows], sum[kRows];
  float weights[kRows];
  for (int k = 0; k < kRows; ++k) {
    vec2 units = vec2(column, min(row + k, tile.side - 1)) / float(tile.side - 1);
    n[k] = normalize(probe_direction(units, tile.below ? -1.0 : 1.0));
    sum[k] = vec3(0.0);
    weights[k] = 0.0;
  }
  float alpha = probe.levels[tile.level].w;
  float a2 = alpha * alpha, slope = a2 - 1.0;
  int width = textureSize(lists, 0).x, last = tile.list.x + tile.list.y;
  for (int i = tile.list.x; i < last; ++i) {
    uvec4 nodes = texelFetch(lists, ivec2(i % width, i / width), 0);
    for (int j = 0; j < 4; ++j) {
      ivec2 at = ivec2(nodes[j] & 65535u, nodes[j] >> 16);
      vec4 place = texelFetch(places, at, 0);
      vec3 light = texelFetch(seen, at, 0).rgb;
      float t = 1.27323954 * a2 * place.w, base = a2 + 1.0 - 0.15915494 * place.w;
      for (int k = 0; k < kRows; ++k) {
        float c = dot(n[k], place.xyz);
        float a = slope * c + base, r2 = a * a + t;
        float weight = t * max(c, 0.0) / (r2 + a * sqrt(r2));
        sum[k] += weight * light;
        weights[k] += weight;
      }
    }
  }
  ivec2 at = tile.origin + ivec2(column + (tile.below ? tile.side : 0), row);
  for (int k = 0; k < kRows; ++k) {
    if (row + k < tile.side) {
      imageStore(map, at + ivec2(0, k), vec4(sum[k] / weights[k], 1.0));
    }
  }
}
