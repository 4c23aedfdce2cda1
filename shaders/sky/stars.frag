// A star's point spread: a Gaussian just wide enough that the sum over pixels is the same wherever
// between them the star stands (to 0.1 %), so that it neither jumps nor shimmers as the camera turns.
layout(location = 0) flat in vec3 light;
layout(location = 1) flat in vec2 centre;
layout(location = 0) out vec4 colour;

void main() {
  vec2 away = gl_FragCoord.xy - centre;
  colour = vec4(min(light * exp(-dot(away, away) / (2.0 * 0.65 * 0.65)), vec3(30000.0)), 0.0);
}
