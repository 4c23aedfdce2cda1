// A rough level of the probe: for each direction n the mean of what is seen, weighed by how much the facets
// about n mirror of it. A facet's normal h lies half way: the density of directions l is D(n.h) / 4 (Walter
// et al. 2007, eq. 14), weighed with n.l (Karis 2013), and (n.h)^2 = (1 + n.l) / 2. The mean is a sum over
// all cells, of which those about n count texel by texel: no samples, and so no noise.
#include "lib/probe.glsl"
#include "sky/probe_cell.glsl"

layout(local_size_x = 16) in;
layout(rgba16f, binding = 0) uniform writeonly image2D map;
layout(std430, binding = 1) readonly buffer Cells { Cell cells[]; };
layout(location = 0) uniform ivec4 region;  // to make: first texel, texels per side, first row
layout(location = 2) uniform float alpha;
layout(location = 3) uniform int side;  // cells per side of a square
layout(location = 5) uniform int near;  // how many cells about n count texel by texel; -1: none

// Texels of a column that one invocation makes: a cell once read serves them all.
const int kTexels = 8;

void main() {
  ivec2 first = ivec2(gl_GlobalInvocationID.x, region.w + kTexels * int(gl_GlobalInvocationID.y));
  if (first.x >= 2 * region.z || first.y >= region.z) return;
  bool below = first.x >= region.z;
  int column = first.x - (below ? region.z : 0), last = min(first.y + kTexels, region.z) - 1;
  vec3 n[kTexels], sum[kTexels];
  float weights[kTexels];
  for (int k = 0; k < kTexels; ++k) {
    vec2 units = vec2(column, min(first.y + k, last)) / float(region.z - 1);
    n[k] = probe_direction(units, below ? -1.0 : 1.0);
    sum[k] = vec3(0.0);
    weights[k] = 0.0;
  }
  // The cells about these directions, in both squares where they reach the level.
  float scale = float(side) / float(region.z);
  ivec2 from = max(ivec2(scale * (vec2(column, first.y) + 0.5)) - near, ivec2(0));
  ivec2 to = min(ivec2(scale * (vec2(column, last) + 0.5)) + near, ivec2(side - 1));
  bool at_level = any(equal(from, ivec2(0))) || any(equal(to, ivec2(side - 1)));
  float slope = 0.5 * (alpha * alpha - 1.0);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < 2 * side; ++x) {
      bool down = x >= side;
      ivec2 cell = ivec2(x - (down ? side : 0), y);
      bool fine = near >= 0 && all(greaterThanEqual(cell, from)) && all(lessThanEqual(cell, to)) &&
                  (down == below || at_level);
      int at = 2 * side * y + x;
      int start = fine ? first_texel_of_cell(at, side) : at, count = fine ? kInCell : 1;
      for (int i = 0; i < count; ++i) {
        vec4 middle = cells[start + i].middle;
        vec3 light = cells[start + i].light.rgb;
        for (int k = 0; k < kTexels; ++k) {
          float cosine = dot(n[k], middle.xyz);
          float width = slope * cosine + slope + 1.0;
          float weight = max(cosine, 0.0) / (width * width);
          sum[k] += weight * light;
          weights[k] += weight * middle.w;
        }
      }
    }
  }
  for (int k = 0; k < kTexels; ++k) {
    if (first.y + k <= last) {
      imageStore(map, region.xy + first + ivec2(0, k), vec4(sum[k] / weights[k], 1.0));
    }
  }
}
