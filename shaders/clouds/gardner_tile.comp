// One period of Gardner's texture function on a plane: two wavelengths either way. Sines by the dozen cost
// more than a texel.
#include "lib/gardner.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(r16, binding = 0) uniform writeonly image2D tile;
layout(location = 0) uniform int terms;
layout(location = 1) uniform float contrast;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  float texels = float(imageSize(tile).x);
  vec2 at = 2.0 * (vec2(texel) + 0.5) / texels;
  imageStore(tile, texel, vec4(gardner_texture(vec3(at, 0.0), terms, contrast, 2.0 / texels)));
}
