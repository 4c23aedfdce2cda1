// What the probe sees as a list of cells, each with its solid angle, its middle and its light: what the
// rough levels and the irradiance are sums over.
#include "lib/probe.glsl"
#include "sky/probe_cell.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 1) writeonly buffer Cells { Cell cells[]; };
layout(rgba32f, binding = 0) uniform readonly image2D seen;
layout(location = 2) uniform int side;    // cells per side of a square
layout(location = 3) uniform int texels;  // per side of a cell

void main() {
  int me = int(gl_GlobalInvocationID.x);
  if (me >= 2 * side * side) return;
  ivec2 corner = ivec2(me % (2 * side), me / (2 * side)) * texels;
  int size = side * texels, first = corner.x >= size ? size : 0;
  vec4 middle = vec4(0.0);
  vec3 light = vec3(0.0);
  for (int i = 0; i < texels * texels; ++i) {
    ivec2 texel = corner + ivec2(i % texels, i / texels);
    vec4 part = imageLoad(seen, texel);
    vec2 units = vec2(texel.x - first, texel.y) / float(size - 1);
    middle += part.a * vec4(probe_direction(units, first > 0 ? -1.0 : 1.0), 1.0);
    light += part.a * part.rgb;
  }
  cells[me].middle = vec4(normalize(middle.xyz), middle.w);
  cells[me].light = vec4(light, 0.0);
}
