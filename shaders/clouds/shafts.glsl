// Shafts: air in the shadow of a cloud scatters less. The picture's air (AirLight) is that of a clear sky;
// what the clouds keep from it is taken away again: single scattering integrated along the ray, as a share of
// the sky's radiance there. So of the sky just that is missing, and of darker things no more than they have. Needs
// clouds/shadow.glsl, clouds/air.glsl and the includer's uniforms before it.

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

// Share of what is seen that is missing along `span`.
float shaft_missing(vec3 direction, CloudSpan span, float jitter) {
  float far = min(span.far, span.near + kShaftReach);
  float cosine = dot(direction, clouds.light_direction.xyz);
  bool by_day = frame.sun_illuminance.g >= frame.moon_illuminance.g;
  vec3 lux = by_day ? frame.sun_illuminance.rgb : frame.moon_illuminance.rgb;
  vec3 lux_aloft = cloud_light_at(1.0e-3 * clouds.layer.w, clouds.light_direction.y, clouds.light_source.rgb);
  float rise = 1.0e3 / max(clouds.layer.w, 1.0);  // 1/km
  // Scattered toward the eye by a metre of air at sea level: of the beam, and of one lux from all round.
  vec3 rayleigh = 1.0e-3 * rayleigh_at_sea_level();
  vec3 mie = vec3(1.0e-3 * sky.aerosol.x);
  vec3 rayleigh_beam = rayleigh * rayleigh_phase(cosine), mie_beam = mie * cornette_shanks(kMieG, cosine);
  const float kEven = 0.25 / kPhasePi;

  vec3 missing = vec3(0.0), depth = vec3(0.0);
  float before = 0.0;
  for (int i = 0; i < steps.x; ++i) {
    float u = (float(i) + jitter) / float(steps.x);
    float along = mix(span.near, far, u * u);
    vec3 p = direction * along;
    float height = 1.0e-3 * max(cloud_altitude(p), 0.0);
    float thin = exp(-height / kRayleighHeight), thick = exp(-height / sky.aerosol.z);
    // What dims it on its way to the eye.
    depth += (along - before) * 1.0e-3 * (rayleigh_at_sea_level() * thin + vec3(sky.aerosol.y * thick));
    before = along;
    float known = cloud_shadow_known(cloud_shadow_at(p, cloud_altitude(p)));
    vec2 kept = mix(kept_by_weather(p), kept_behind(cloud_shadow_depth(p)), known);
    vec3 beam = (1.0 - kept.x) * (thin * rayleigh_beam + thick * mie_beam);
    // What the cloud lets through scattered comes from all round instead.
    vec3 spread = (kept.y - kept.x) * kEven * (thin * rayleigh + thick * mie);
    missing += u * exp(-depth) * (beam - spread) * mix(lux, max(lux_aloft, lux), min(height * rise, 1.0));
  }
  missing *= 2.0 * (far - span.near) / float(steps.x);
  float given = cloud_air(direction, far, cloud_altitude(direction * far)).inscattered.g;
  return amount.x * clamp(missing.g, 0.0, 0.95 * given) / max(sky_radiance(direction).g, 1.0e-9);
}
