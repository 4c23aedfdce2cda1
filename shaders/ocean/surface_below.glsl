// The sea's surface seen from the water. Needs shared/frame.h, shared/ocean.h, sky/sky.glsl,
// sky/probe.glsl, ocean/surface.glsl, ocean/ripples.glsl, ocean/foam.glsl and ocean/underwater.glsl before it.

struct Underside {
  vec2 slope;       // in space
  vec3 covariance;  // of slopes that this size does not resolve: xx, zz, xz
  float foam;       // share of the surface
};

Underside read_underside(vec2 parameter, float footprint) {
  vec4 sum = vec4(0.0);
  float cross_term = 0.0;
  vec3 squeeze = vec3(0.0);  // of the breaking waves
  int cascades = int(ocean.water.y);
  for (int c = 0; c < cascades; ++c) {
    float level = sea_map_level(c, footprint);
    float share = sea_map_share(level);
    if (share <= 0.0) break;
    vec3 place = sea_map_place(c, parameter);
    sum += share * textureLod(sea_slopes, place, level);
    cross_term += share * textureLod(sea_displacement, place, level).w;
    if (c < int(ocean.foam.z)) squeeze = vec3(sum.zw, cross_term);
  }
#ifdef RIPPLES
  sum.xy += ripples(cascades - 1, parameter, log2(footprint));
#endif
  Underside under;
  under.slope = surface_slope(sum.x, sum.y, sum.z, sum.w, cross_term);
  under.covariance = max(sea_missing(log2(footprint)).xyz, vec3(4.0e-4, 4.0e-4, -1.0));
  float bound = 0.9 * sqrt(under.covariance.x * under.covariance.y);
  under.covariance.z = clamp(under.covariance.z, -bound, bound);
  under.foam = sea_foam(parameter, footprint, surface_jacobian(squeeze.x, squeeze.y, squeeze.z),
                        sea_unresolved(footprint)).opacity;
  return under;
}

// Radiance of the deep water toward which the underside mirrors.
vec3 depths(Daylight day, vec3 direction) {
  vec3 down = normalize(vec3(direction.x, min(direction.y, -0.02), direction.z));
  PathLight light = path_light(day, 0.0, down, kFarAway);
  return light.from_sky + light.from_light;
}

// What facets let through: the sky, brighter by the square of the index, since rays crowd together in
// water.
vec3 through_facets(vec3 direction, vec3 normal, Window window, float sigma) {
  float out2 = max(1.0 - kWaterIndex * kWaterIndex * (1.0 - window.cosine * window.cosine), 0.0);
  vec3 bent = kWaterIndex * direction + (sqrt(out2) - kWaterIndex * window.cosine) * normal;
  vec3 sky_light = probe_radiance(normalize(vec3(bent.x, max(bent.y, 0.01), bent.z)), sqrt(sigma));
  return sky_light * (window.passing * kWaterIndex * kWaterIndex);
}
