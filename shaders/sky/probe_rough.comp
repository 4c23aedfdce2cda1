// A rough level of the probe: for each direction the sum over all cells by how much the facets about it
// mirror of each. No samples, so no noise. A facet's normal h lies half way: the share of directions l
// is D(n.h) / 4 (Walter et al. 2007, eq. 14), weighed with n.l (Karis 2013), and (n.h)^2 = (1 + n.l) / 2.
#include "sky/probe_map.glsl"
#include "sky/probe_cell.glsl"

layout(local_size_x = 16) in;
layout(rgba16f, binding = 0) uniform writeonly image2D map;
layout(std430, binding = 1) readonly buffer Cells { Cell cells[]; };
layout(location = 2) uniform float alpha;
layout(location = 3) uniform int count;

// Texels of a column that one invocation makes: a cell once read serves them all.
const int kTexels = 8;

void main() {
  ivec2 first = ivec2(gl_GlobalInvocationID.x, region.w + kTexels * int(gl_GlobalInvocationID.y));
  if (first.x >= 2 * region.z || first.y >= region.z) return;
  bool below = first.x >= region.z;
  vec3 n[kTexels], sum[kTexels];
  float weights[kTexels];
  for (int k = 0; k < kTexels; ++k) {
    vec2 units = vec2(first.x - (below ? region.z : 0), min(first.y + k, region.z - 1)) /
                 float(region.z - 1);
    n[k] = probe_direction(units, below ? -1.0 : 1.0);
    sum[k] = vec3(0.0);
    weights[k] = 0.0;
  }
  float slope = 0.5 * (alpha * alpha - 1.0);
  for (int i = 0; i < count; ++i) {
    vec4 middle = cells[i].middle;
    vec3 light = cells[i].light.rgb;
    for (int k = 0; k < kTexels; ++k) {
      float cosine = dot(n[k], middle.xyz);
      float width = slope * cosine + slope + 1.0;
      float weight = max(cosine, 0.0) / (width * width);
      sum[k] += weight * light;
      weights[k] += weight * middle.w;
    }
  }
  for (int k = 0; k < kTexels; ++k) {
    if (first.y + k < region.z) {
      imageStore(map, region.xy + first + ivec2(0, k), vec4(sum[k] / weights[k], 1.0));
    }
  }
}
