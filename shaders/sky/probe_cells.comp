// The probe's cells from their texels: solid angle, middle and light.
#include "sky/probe_cell.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 1) buffer Cells { Cell cells[]; };
layout(location = 3) uniform int side;  // cells per side of a square

void main() {
  int me = int(gl_GlobalInvocationID.x);
  if (me >= 2 * side * side) return;
  vec4 middle = vec4(0.0), light = vec4(0.0);
  for (int i = 0; i < kInCell; ++i) {
    Cell texel = cells[first_texel_of_cell(me, side) + i];
    middle += texel.middle.w * vec4(texel.middle.xyz, 1.0);
    light += texel.light;
  }
  cells[me].middle = vec4(normalize(middle.xyz), middle.w);
  cells[me].light = light;
}
