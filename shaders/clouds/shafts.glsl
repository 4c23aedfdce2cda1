// Shafts: air in the shadow of a cloud scatters less. The picture's air (AirLight) is that of a clear sky;
// what the clouds keep from it is taken away again, as a share of what is seen: of that the air has given
// about its own opacity. So light is only removed, and never more than there is. Needs clouds/shadow.glsl,
// clouds/air.glsl and the includer's uniforms before it.

// Share of the picture's light that is missing along `span`.
float shaft_missing(vec3 direction, CloudSpan span, float jitter) {
  float far = min(span.far, span.near + kShaftReach);
  vec3 toward = clouds.light_direction.xyz;
  bool by_day = frame.sun_illuminance.g >= frame.moon_illuminance.g;
  vec3 lux = by_day ? frame.sun_illuminance.rgb : frame.moon_illuminance.rgb;
  float cosine = dot(direction, toward);
  // Of what the air scatters toward the eye: what came straight from the light, and for one lux that comes
  // from all round instead.
  vec3 rayleigh = rayleigh_at_sea_level();
  float mie = sky.aerosol.x;
  vec3 once = lux * (rayleigh * rayleigh_phase(cosine) + vec3(mie * cornette_shanks(kMieG, cosine)));
  vec3 even = rayleigh + vec3(mie);
  // Mean radiance all round: the sky above, next to nothing from the sea below.
  vec3 all = once + even * frame.sky_illuminance.rgb * (0.5 / kPhasePi);
  vec3 straight = once / all;
  vec3 spread = even * lux * (0.25 / kPhasePi) / all;

  float kept_beam = 0.0, kept_all = 0.0, weights = 1.0e-6;
  float haze = frame.haze.g;
  for (int i = 0; i < steps.x; ++i) {
    float u = (float(i) + jitter) / float(steps.x);
    float along = mix(span.near, far, u * u);
    vec3 p = direction * along;
    float weight = 2.0 * u * exp(-haze * (along - span.near) - 1.0e-3 * cloud_altitude(p) / sky.aerosol.z);
    float depth = cloud_shadow_depth(p);
    float scaled = 0.15 * depth;  // (1 - g) of droplets
    kept_beam += weight * exp(-depth);
    // What comes through a cloud in all: Eddington's transmittance (lib/cloud_scattering.glsl).
    kept_all += weight * (5.0 - exp(-scaled)) / (4.0 + 3.0 * scaled);
    weights += weight;
  }
  kept_beam /= weights;
  kept_all /= weights;
  vec3 share = clamp(straight * (1.0 - kept_beam) - spread * max(kept_all - kept_beam, 0.0), vec3(0.0),
                     vec3(1.0));
  vec3 air = cloud_air(direction, far, cloud_altitude(direction * far)).transmittance;
  return amount.x * share.g * (1.0 - air.g);
}
