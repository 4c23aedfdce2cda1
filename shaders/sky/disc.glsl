// What sun and moon share. Needs shared/frame.h and sky/sky.glsl.
layout(binding = OFFING_UNIT_TRANSMITTANCE) uniform sampler2D transmittance_table;

vec3 air_transmittance(float cosine) {
  vec2 unit = transmittance_units(sky.observer.x, max(cosine, -sky.observer.y));
  vec2 at = 0.5 / sky.table_texels.zw + unit * (1.0 - 1.0 / sky.table_texels.zw);
  return srgb_from_bands(textureLod(transmittance_table, at, 0.0).rgb);
}

// Exact for small angles, where the cosine alone is not.
float sine_between(vec3 a, vec3 b) { return length(cross(a, b)); }

// How much of this pixel a disc of this radius covers (sines of small angles).
float disc_cover(float sine, float radius) {
  return clamp(0.5 + (radius - sine) / frame.camera.w, 0.0, 1.0);
}
