// What sun and moon share. Needs shared/frame.h and sky/sky.glsl.
layout(binding = OFFING_UNIT_TRANSMITTANCE) uniform sampler2D transmittance_table;

vec3 air_transmittance(float cosine) {
  vec2 unit = transmittance_units(sky.observer.x, max(cosine, -sky.observer.y));
  vec2 at = 0.5 / sky.table_texels.zw + unit * (1.0 - 1.0 / sky.table_texels.zw);
  // A sky that is only painted has no table.
  return mix(vec3(1.0), srgb_from_bands(textureLod(transmittance_table, at, 0.0).rgb), sky.lights.z);
}

// Exact for small angles, where the cosine alone is not.
float sine_between(vec3 a, vec3 b) { return length(cross(a, b)); }

// How much of this pixel a disc of this radius covers (sines of small angles).
float disc_cover(float sine, float radius) {
  return clamp(0.5 + (radius - sine) / frame.camera.w, 0.0, 1.0);
}

// Refraction lifts a disc's lower limb more than its upper one: near the horizon it looks flattened.
// Where a direction near a body that is flattened to `squeeze` of its height would be without that.
vec3 unsqueezed(vec3 direction, vec3 body, float squeeze) {
  vec3 right = normalize(cross(body, vec3(0.0, 1.0, 1.0e-4)));
  vec3 above = cross(right, body);
  return normalize(direction + above * (dot(direction - body, above) * (1.0 / squeeze - 1.0)));
}
