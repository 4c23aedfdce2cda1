// Which water a pixel shows: so much and no more is drawn with the mesh, whose triangles are small; light
// is worked out afterwards, once for every pixel.
in vec3 relative;
in vec2 parameter;
layout(location = 0) out vec4 seen;  // water at rest (x, z relative to the camera), size it covers, distance
#ifdef HULL
layout(binding = 3) uniform sampler2D dry;  // 1 / distance to a hull's near side, distance to its far side
#endif

void main() {
  float distance = length(relative);
#ifdef HULL
  vec2 hull = texelFetch(dry, ivec2(gl_FragCoord.xy), 0).xy;
  if (distance * hull.x > 1.0 && distance < hull.y) discard;
#endif
  // A part of the longer side of the pixel's footprint: isotropic filtering over all of it would blur
  // wave faces seen at a slant, over none of it would shimmer.
  vec2 dx = dFdx(parameter), dy = dFdy(parameter);
  float longer = sqrt(max(dot(dx, dx), dot(dy, dy))), shorter = sqrt(min(dot(dx, dx), dot(dy, dy)));
  float footprint = max(max(shorter, longer / FOOTPRINT_RATIO), 1.0e-3);
#ifdef TWO_SIDED
  // Negative where it is seen from below.
  footprint = gl_FrontFacing ? footprint : -footprint;
#endif
  seen = vec4(parameter, footprint, distance);
}
