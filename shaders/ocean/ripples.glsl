// Slope of ripples that no cascade carries: the finest one's picture, smaller, carried along by as much as
// real ones are faster. (Short waves hold much the same slope in each octave: Phillips 1958.) Needs
// ocean/surface.glsl before it. `size`: log2 of m.
vec2 ripples(int finest, vec2 parameter, float size) {
  float level = sea_map_level_log2(finest, size - log2(kRippleScale));
  float share = sea_map_share(level) * ocean.grid[finest].w;
  vec2 g = ocean.grid[finest].xy / kRippleScale;
  vec2 away = vec2(g.x * parameter.x + g.y * parameter.y, g.x * parameter.y - g.y * parameter.x);
  vec3 place = vec3(ocean.origin[finest].zw + away, float(finest));
#ifdef PICK_LEVELS
  level = sea_map_level_picked(level, sea_die());
#endif
  return share * textureLod(sea_slopes, place, level).xy;
}
