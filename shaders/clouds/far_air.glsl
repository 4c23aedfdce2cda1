// Light on its way to a cloud, and from the cloud to the eye. Needs shared/frame.h and sky/sky.glsl.
layout(binding = OFFING_UNIT_TRANSMITTANCE) uniform sampler2D far_air_table;

// What the air above a height (km) lets through toward a cosine with the zenith there.
vec3 far_air_transmittance(float height, float cosine) {
  vec2 unit = transmittance_units(height, max(cosine, -horizon_dip_sine(height)));
  vec2 at = 0.5 / sky.table_texels.zw + unit * (1.0 - 1.0 / sky.table_texels.zw);
  return textureLod(far_air_table, at, 0.0).rgb;
}

// Share of a light's illuminance above the air that reaches a place `height` (m) up, `away` (m; x, z)
// from the camera: the earth's shadow climbs the sky after sunset.
vec3 light_aloft(float height, vec2 away, vec3 direction) {
  float km = max(height, 0.0) * 1.0e-3;
  vec3 up = normalize(vec3(away.x, kPlanetRadius * 1.0e3, away.y));
  float cosine = dot(direction, up);
  return srgb_from_bands(far_air_transmittance(km, cosine)) *
         soft_share_above_horizon(km, cosine, 0.00465);
}

// The air between the eye and a thing `height` (m) up, in a direction above the horizon: seen = thing ×
// transmittance + inscattered. The sky's light along the ray is shared out as its optical depth is.
AirLight air_before(float height, vec2 away, vec3 direction) {
  vec3 up = normalize(vec3(away.x, kPlanetRadius * 1.0e3, away.y));
  vec3 all = srgb_from_bands(far_air_transmittance(sky.observer.x, direction.y));
  vec3 beyond = srgb_from_bands(far_air_transmittance(max(height, 0.0) * 1.0e-3, dot(direction, up)));
  AirLight air;
  air.transmittance = clamp(all / max(beyond, vec3(1.0e-6)), vec3(0.0), vec3(1.0));
  air.inscattered = sky_radiance(direction) * (vec3(1.0) - air.transmittance) /
                    max(vec3(1.0) - all, vec3(1.0e-4));
  return air;
}
