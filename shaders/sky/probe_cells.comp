// Level 0 of the probe as a list of cells, each with its solid angle, its middle and its light: what the
// rough levels and the irradiance are sums over.
#include "sky/probe_map.glsl"
#include "sky/probe_cell.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 1) writeonly buffer Cells { Cell cells[]; };
layout(location = 2) uniform int side;  // cells per side of a square

void main() {
  int me = int(gl_GlobalInvocationID.x);
  if (me >= 2 * side * side) return;
  bool below = me >= side * side;
  vec2 corner = vec2(me % side, (me / side) % side);
  vec4 middle = vec4(0.0);
  vec3 light = vec3(0.0);
  for (int i = 0; i < 4; ++i) {
    vec2 units = (corner + 0.25 + 0.5 * vec2(i & 1, i >> 1)) / float(side);
    float angle = probe_solid_angle(units) / float(4 * side * side);
    middle += angle * vec4(probe_direction(units, below ? -1.0 : 1.0), 1.0);
    light += angle * read_level(source, units, below);
  }
  cells[me].middle = vec4(normalize(middle.xyz), middle.w);
  cells[me].light = vec4(light, 0.0);
}
