// Drops thin out toward the rim of their cloud and lie in tufts.
layout(binding = 2) uniform sampler2D foam_pattern;
in vec2 corner;
flat in vec2 tuft;
flat in vec4 light;
layout(location = 0) out vec4 colour;  // over the picture: radiance × exposure × opacity, opacity

void main() {
  float inside = max(1.0 - dot(corner, corner), 0.0);
  float pattern = textureLod(foam_pattern, tuft + vec2(0.03, 0.09) * corner, 0.0).r;
  float tufts = smoothstep(-0.05, 0.35, pattern * 0.125 + inside * 0.35);
  float opacity = light.w * inside * tufts;
  colour = vec4(light.rgb * opacity, opacity);
}
