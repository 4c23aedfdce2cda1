// The sky above the horizon for one light of 1 lux above the air. Depends on the light's elevation,
// the observer's height and the air, on nothing else: azimuth and strength are the reader's business.
// Alpha: the night's glow over its value above the air at the zenith: what gets through, and, in place
// of what does not, glow scattered in from all over the sky.
#include "sky/air_tables.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = 0) uniform writeonly image2D table;
layout(location = 0) uniform vec3 aerosol;
layout(location = 1) uniform vec2 place;  // x: height (km), y: cosine of the light's zenith angle

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = imageSize(table);
  if (any(greaterThanEqual(texel, size))) return;
  Aerosol air_here = Aerosol(aerosol.x, aerosol.y, aerosol.z);
  float height = place.x, light_cosine = place.y;
  SkyViewPlace view = sky_view_place(vec2(texel) / vec2(size - 1));

  float dip_sine = horizon_dip_sine(height);
  float dip_cosine = sqrt(1.0 - dip_sine * dip_sine);
  float above = view.sine_above_horizon;
  float cosine = above * dip_cosine - sqrt(max(1.0 - above * above, 0.0)) * dip_sine;
  float towards = cosine * light_cosine +
                  sqrt(max((1.0 - cosine * cosine) * (1.0 - light_cosine * light_cosine), 0.0)) *
                      view.cosine_azimuth;
  float rayleigh = rayleigh_phase(towards);
  float mie = cornette_shanks(kMieG, towards);

  float along = distance_to_top(height, cosine);
  vec3 radiance = vec3(0.0), transmittance = vec3(1.0);
  for (int s = 0; s < STEPS; ++s) {
    float x0 = float(s) / float(STEPS), x1 = float(s + 1) / float(STEPS);
    float xm = 0.5 * (x0 + x1);
    float step_length = along * (x1 * x1 - x0 * x0);
    float d = along * xm * xm;
    float h = max(height_along(height, cosine, d), 0.0);
    float c = cosine_along(height, light_cosine, towards, d, h);
    Air air = air_at(air_here, h);
    vec3 source = light_transmittance(h, c) * (air.rayleigh * rayleigh + air.mie * mie) +
                  table_multiscatter(h, c) * (air.rayleigh + air.mie);
    vec3 step_transmittance = exp(-air.extinction * step_length);
    radiance += transmittance * source * (vec3(1.0) - step_transmittance) / air.extinction;
    transmittance *= step_transmittance;
  }
  float glow = dot(table_transmittance(height, max(cosine, -dip_sine)), vec3(0.2126, 0.7152, 0.0722));
  imageStore(table, texel, vec4(srgb_from_bands(radiance), glow * van_rhijn(cosine) + 0.8 * (1.0 - glow)));
}
