// Drops thin out toward the rim of their cloud and lie in wisps along its way.
#include "ocean/spray.glsl"
layout(binding = 2) uniform sampler2D foam_pattern;
in vec2 corner;
flat in vec3 tuft;
flat in vec4 light;
layout(location = 0) out vec4 colour;  // over the picture: radiance × exposure × opacity, opacity

void main() {
  float inside = max(1.0 - dot(corner, corner), 0.0);
  float pattern = textureLod(foam_pattern, tuft.xy + kSprayTuft * corner, tuft.z).r;
  float wisps = smoothstep(0.0, 0.6, pattern * 0.22 + inside * 0.3);
  float opacity = light.w * inside * wisps;
  colour = vec4(light.rgb * opacity, opacity);
}
