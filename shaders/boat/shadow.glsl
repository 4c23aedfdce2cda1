// What the boat leaves of the brighter light. Of the C++ side BoatShadow::read_by() and bind().
#include "shared/boat_shadow.h"

// Depth from the light; on the left of what is opaque, on the right of cloth.
layout(binding = OFFING_UNIT_BOAT_SHADOW) uniform sampler2DShadow boat_shadow_map;

vec3 boat_shadow_place(vec3 relative) {
  return (boat_shadow.map_from_relative * vec4(relative, 1.0)).xyz;
}

// Whether a place in the map may lie in the shadow.
bool boat_shadow_reaches(vec3 place) {
  vec2 off = abs(place.xy - 0.5);
  return boat_shadow.light.w >= 0.0 && max(off.x, off.y) < 0.5 && place.z > 0.0;
}

// Whether no place of a line (its ends relative to the camera, m) can lie in the shadow.
bool boat_shadow_misses(vec3 from, vec3 to) {
  vec2 a = boat_shadow_place(from).xy - 0.5, b = boat_shadow_place(to).xy - 0.5;
  return boat_shadow.light.w < 0.0 || any(greaterThan(min(a, b), vec2(0.5))) ||
         any(lessThan(max(a, b), vec2(-0.5)));
}

// Share of a half of the map (0: opaque, 0.5: cloth) that lets light through to a place, over one or
// four texels and their neighbours.
float boat_shadow_open(vec3 place, float half_) {
  const vec2 kTaps[4] = vec2[](vec2(0.4, 1.2), vec2(-1.2, 0.4), vec2(-0.4, -1.2), vec2(1.2, -0.4));
  float texel = boat_shadow.map.y;
  int taps = int(boat_shadow.map.x);
  float spread = taps > 1 ? texel : 0.0;
  vec2 at = clamp(place.xy, vec2(3.0 * texel), vec2(1.0 - 3.0 * texel));
  float sum = 0.0;
  for (int i = 0; i < taps; ++i) {
    vec2 tap = at + spread * kTaps[i];
    sum += textureLod(boat_shadow_map, vec3(0.5 * tap.x + half_, tap.y, min(place.z, 1.0)), 0.0);
  }
  return sum / float(taps);
}

// Share of the light that reaches a place (relative to the camera, m) past spars, hull and sails.
float boat_shade(vec3 relative) {
  vec3 place = boat_shadow_place(relative);
  if (!boat_shadow_reaches(place)) return 1.0;
  // Cloth waves, and its edges are not sharp: what is this near to it is it.
  const float kCloth = 0.15;  // m
  float open = boat_shadow_open(place, 0.0);
  float past_cloth = boat_shadow_open(place - vec3(0.0, 0.0, kCloth * boat_shadow.map.z), 0.5);
  return open * mix(boat_shadow.map.w, 1.0, past_cloth);
}
