// The sea's surface seen from the water. Needs shared/frame.h, shared/ocean.h, sky/sky.glsl,
// sky/probe.glsl, ocean/surface.glsl and ocean/underwater.glsl before it.
layout(binding = 2) uniform sampler2D foam_pattern;  // evenly distributed over 0 … 1

struct Underside {
  vec2 slope;       // in space
  vec3 covariance;  // of slopes that this size does not resolve: xx, zz, xz
  float foam;       // share of the surface
};

Underside read_underside(vec2 parameter, float footprint) {
  vec4 sum = vec4(0.0);
  vec3 squeeze = vec3(0.0), resolved = vec3(0.0);
  float cross_term = 0.0, shown = 0.0;
  int cascades = int(ocean.water.y);
  for (int c = 0; c < cascades; ++c) {
    float level = sea_map_level(c, footprint);
    float share = sea_map_share(level);
    if (share <= 0.0) break;
    vec3 place = sea_map_place(c, parameter);
    vec4 slopes = share * textureLod(sea_slopes, place, level);
    float mixed = share * textureLod(sea_displacement, place, level).w;
    sum += slopes;
    cross_term += mixed;
    squeeze += ocean.grid[c].w * vec3(slopes.zw, mixed);
    float entry = min(level, float(kOceanMapLevels - 1));
    int first = c * kOceanMapLevels + min(int(entry), kOceanMapLevels - 2);
    vec4 kept = share * share *
                mix(ocean.resolved[first], ocean.resolved[first + 1], entry - floor(entry));
    resolved += kept.xyz;
    shown += ocean.grid[c].w * kept.w;
  }
  Underside under;
  under.slope = surface_slope(sum.x, sum.y, sum.z, sum.w, cross_term);
  under.covariance = max(ocean.variance.xyz - resolved, vec3(4.0e-4, 4.0e-4, -1.0));
  float bound = 0.9 * sqrt(under.covariance.x * under.covariance.y);
  under.covariance.z = clamp(under.covariance.z, -bound, bound);

  // Foam as surface.frag has it: where the summed surface is squeezed, broken up by a pattern.
  float jacobian = surface_jacobian(squeeze.x, squeeze.y, squeeze.z);
  float unresolved = max(ocean.foam.z - shown, 0.0) * ocean.foam.y;
  float coverage = normal_below((ocean.foam.x - jacobian) / sqrt(unresolved + ocean.foam.w));
  vec2 along = ocean.foam_grid.zw;
  vec2 at = ocean.foam_grid.xy + vec2(dot(along, parameter), ocean.foam_stretch.x *
            (along.x * parameter.y - along.y * parameter.x));
  float fineness = log2(max(footprint * length(along) * ocean.foam_stretch.y, 1.0e-6));
  float pattern = 0.5 * (textureLod(foam_pattern, at, fineness).r +
                         textureLod(foam_pattern, 2.7 * at.yx, fineness + 1.4).r);
  pattern = pattern < 0.5 ? 2.0 * pattern * pattern : 1.0 - 2.0 * (1.0 - pattern) * (1.0 - pattern);
  float soft = min(0.2, coverage);
  under.foam = smoothstep(1.0 - coverage - soft, 1.0 - coverage + soft + 1.0e-4, pattern);
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
