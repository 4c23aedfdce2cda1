// What the clouds leave of sun and moon. Needs shared/frame.h before it; of the C++ side
// CloudShadow::bind() and CloudShadowIds::read_by().
#include "shared/bindings.h"
#include "shared/clouds.h"

layout(binding = OFFING_UNIT_CLOUD_SHADOW) uniform sampler2D cloud_shadow_map;  // see shadow.comp

// Where the light's ray through a place crosses the level of the map.
vec2 cloud_shadow_at(vec3 relative, float altitude) {
  vec3 toward = clouds.shadow_light.xyz;
  vec2 plan = relative.xz + toward.xz * ((clouds.shadow.w - altitude) / toward.y);
  return (plan - clouds.shadow.xy) * clouds.shadow.z + 0.5;
}

// 1 within the map, 0 at its rim.
float cloud_shadow_known(vec2 at) {
  vec2 inside = min(at, vec2(1.0) - at) * 12.0;
  return clamp(min(inside.x, inside.y), 0.0, 1.0);
}

// Of the light's ray through a place: optical depth between it and the light; that behind another place on the ray,
// at a height of `behind` (m); how far the map knows them, 0 to 1.
vec3 cloud_shadow_depths(vec3 relative, float behind) {
  float altitude = clouds.eye.x + relative.y + dot(relative.xz, relative.xz) * clouds.eye.y;
  vec2 at = cloud_shadow_at(relative, altitude);
  vec4 map = textureLod(cloud_shadow_map, at, 0.0);
  vec2 below = max(map.gg - vec2(altitude, behind), vec2(0.0)) / clouds.shadow_light.y;
  vec2 depths = min(map.rr, map.b * below);
  return vec3(depths.x, map.r - depths.y, cloud_shadow_known(at));
}

// Optical depth between a place and the light.
float cloud_shadow_depth(vec3 relative) {
  vec3 depths = cloud_shadow_depths(relative, 0.0);
  return depths.x * depths.z;
}

// Share of the brighter light's illuminance that reaches a point, relative to the camera, as a beam. What
// comes through a cloud scattered is in the probe, which sees the clouds (clouds/map.comp).
float cloud_shadow(vec3 relative) { return exp(-cloud_shadow_depth(relative) * clouds.eye.z); }
