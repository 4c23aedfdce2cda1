layout(location = 0) in vec3 light;
layout(location = 0) out vec4 colour;

void main() {
  vec2 from_centre = (gl_PointCoord - 0.5) * 3.0;  // pixels
  colour = vec4(light * exp(-dot(from_centre, from_centre) / (2.0 * 0.6 * 0.6)), 0.0);
}
