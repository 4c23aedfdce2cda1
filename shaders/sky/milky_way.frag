// The band of the Milky Way, added to the sky before it.
layout(binding = 0) uniform sampler2D map;
layout(location = 0) in vec2 at;
layout(location = 1) in vec3 radiance;
layout(location = 2) in float above;
layout(location = 0) out vec4 colour;

void main() {
  // No levels of detail: texels are larger than pixels, and none across the seam of the longitude.
  colour = vec4(radiance * (textureLod(map, at, 0.0).r * step(0.0, above)), 0.0);
}
