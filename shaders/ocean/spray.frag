// Drops thin out toward the rim of their cloud and lie in tufts.
layout(binding = 2) uniform sampler2D foam_pattern;
in vec2 corner;
flat in vec2 tuft;
flat in vec4 light;
layout(location = 0) out vec4 colour;  // over the picture: radiance × exposure × opacity, opacity

void main() {
  float inside = max(1.0 - dot(corner, corner), 0.0);
  float tufts = clamp(3.2 * textureLod(foam_pattern, tuft + 0.07 * corner, 0.0).r - 1.1 + inside, 0.0, 1.0);
  float opacity = light.w * inside * tufts;
  colour = vec4(light.rgb * opacity, opacity);
}
