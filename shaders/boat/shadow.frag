// Only depth is kept.
#ifdef CLOTH
layout(binding = 0) uniform sampler2D cloth_picture;  // b: where there is cloth
in vec2 cloth_uv;
#endif

void main() {
#ifdef CLOTH
  if (texture(cloth_picture, cloth_uv).b < 0.5) discard;
#endif
}
