// Air between the eye and a cloud at any height. Needs shared/frame.h, sky/sky.glsl before it.

layout(binding = OFFING_UNIT_TRANSMITTANCE) uniform sampler2D cloud_air_table;

vec3 cloud_air_transmittance(float height_km, float cosine) {
  vec2 unit = transmittance_units(height_km, cosine);
  vec2 at = 0.5 / sky.table_texels.zw + unit * (1.0 - 1.0 / sky.table_texels.zw);
  return textureLod(cloud_air_table, at, 0.0).rgb;
}

// Colour and strength (lux) at a height (km) of a light with this cosine to the zenith there.
vec3 cloud_light_at(float height_km, float cosine, vec3 source) {
  const float kRadius = 0.00465;
  float horizon = -horizon_dip_sine(height_km);
  vec3 bands = cloud_air_transmittance(height_km, max(cosine, horizon));
  return source * srgb_from_bands(bands) * soft_share_above_horizon(height_km, cosine, kRadius);
}

// Mean of e^(-h/scale) between two heights.
float mean_exponential(float h0, float h1, float scale) {
  float a = exp(-h0 / scale), b = exp(-h1 / scale);
  return abs(h1 - h0) < 0.01 * scale ? 0.5 * (a + b) : scale * (a - b) / (h1 - h0);
}

// What one sees of something at `distance` (m): thing × transmittance + the share of the whole sky's
// light in that direction that is scattered in before it.
AirLight cloud_air(vec3 direction, float distance, float altitude) {
  float h0 = max(sky.observer.x, 0.0), h1 = max(1.0e-3 * altitude, 0.0), km = 1.0e-3 * distance;
  vec3 depth = km * (rayleigh_at_sea_level() * mean_exponential(h0, h1, kRayleighHeight) +
                     vec3(sky.aerosol.y * mean_exponential(h0, h1, sky.aerosol.z)));
  vec3 whole = -log(max(cloud_air_transmittance(h0, max(direction.y, -sky.observer.y)), vec3(1.0e-6)));
  vec3 through = exp(-depth);
  AirLight air;
  air.transmittance = max(srgb_from_bands(through), vec3(0.0));  // (saturated reds lie outside sRGB)
  air.inscattered = sky_radiance(direction) *
                    clamp((vec3(1.0) - through) / (vec3(1.0) - exp(-max(whole, depth))), 0.0, 1.0);
  return air;
}
