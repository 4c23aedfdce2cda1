// Shafts: air in the shadow of a cloud scatters less. The picture's air (AirLight) is that of a clear sky;
// what the clouds keep from it is taken away again, as a share of what is seen: of that the air has given
// about its own opacity. So light is only removed, and never more than there is. Needs clouds/shadow.glsl,
// clouds/air.glsl and the includer's uniforms before it.

// What is left of the light at a place: of its beam (x), and in all (y; Eddington's transmittance,
// lib/cloud_scattering.glsl), behind this optical depth of cloud.
vec2 kept_behind(float depth) {
  float scaled = 0.15 * depth;  // (1 - g) of droplets
  return vec2(exp(-depth), (5.0 - exp(-scaled)) / (4.0 + 3.0 * scaled));
}

// The same in the mean from the weather alone, for places beyond the shadow map: single clouds are not
// told apart there, but a sky half covered keeps half of the light.
vec2 kept_by_weather(vec3 p) {
  const float kNoiseReach = 0.4;  // how far the body's noise lies from its mean, nearly always
  const float kFreedom = 0.65;    // mean of cloud_freedom()
  vec3 toward = clouds.shadow_light.xyz;
  vec2 plan = p.xz + toward.xz * ((clouds.layer.w - cloud_altitude(p)) / toward.y);
  CloudColumn column = cloud_column(plan);
  CloudKind kind = cloud_kind(column.type);
  float inside = cloud_strength(kind, column.excess) - clouds.form.x;
  float freedom = max(kFreedom * kind.roughness * clouds.form.y, 0.05);
  float covered = smoothstep(-kNoiseReach, kNoiseReach, inside / freedom);
  float thickness = kind.thickness * clouds.form.w * clamp(0.5 * inside + 0.25, 0.1, 1.0);
  float depth = 0.5 * clouds.layer.z * kind.extinction * thickness / toward.y;
  return mix(vec2(1.0), kept_behind(depth), covered);
}

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

  vec2 kept = vec2(0.0);
  float weights = 1.0e-6;
  float haze = frame.haze.g;
  for (int i = 0; i < steps.x; ++i) {
    float u = (float(i) + jitter) / float(steps.x);
    float along = mix(span.near, far, u * u);
    vec3 p = direction * along;
    float weight = 2.0 * u * exp(-haze * (along - span.near) - 1.0e-3 * cloud_altitude(p) / sky.aerosol.z);
    float known = cloud_shadow_known(cloud_shadow_at(p, cloud_altitude(p)));
    kept += weight * mix(kept_by_weather(p), kept_behind(cloud_shadow_depth(p)), known);
    weights += weight;
  }
  kept /= weights;
  vec3 share = clamp(straight * (1.0 - kept.x) - spread * max(kept.y - kept.x, 0.0), vec3(0.0),
                     vec3(1.0));
  vec3 air = cloud_air(direction, far, cloud_altitude(direction * far)).transmittance;
  return amount.x * share.g * (1.0 - air.g);
}
