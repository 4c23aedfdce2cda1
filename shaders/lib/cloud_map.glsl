// The cloud map: the octahedron's upper half (Cigolle et al., "A Survey of Efficient Representations for
// Independent Unit Vectors", JCGT 2014), turned by 45 degrees so that the horizon is the square's edge.
// Compiled as GLSL and as double C++.

// Place of an upward direction in the map, 0 to 1.
vec2 cloud_map_units(vec3 d) {
  vec2 p = vec2(d.x, d.z) / (abs(d.x) + max(d.y, 0.0) + abs(d.z));
  return 0.5 + 0.5 * vec2(p.x + p.y, p.y - p.x);
}

// The direction (unit) of a place.
vec3 cloud_map_direction(vec2 units) {
  float p = 2.0 * units.x - 1.0;
  float q = 2.0 * units.y - 1.0;
  float x = 0.5 * (p - q);
  float z = 0.5 * (p + q);
  return normalize(vec3(x, 1.0 - abs(x) - abs(z), z));
}
