// What a pixel shows of the waves, of CASCADES of them, and what it does not. Needs ocean/surface.glsl and
// lib/water.glsl before it; with RIPPLES ocean/ripples.glsl. With PICK_LEVELS a pixel reads one of two map
// levels, by sea_die().

const int kMostBreaking = min(CASCADES, 2);  // cascades whose waves can be long enough to break

struct Surface {
  vec2 slope;       // mean slope in the pixel, in space
  vec3 covariance;  // of the slopes within the pixel: xx, zz, xz
  float jacobian;   // of the waves that can break
  float unresolved; // share of its variance within the pixel
};

// How water is sheared, Dxz. Low reads it by chance from one point of the map: only its products count, and
// are small.
float sea_shear(vec3 place, float level) {
#ifdef PICK_LEVELS
  int across = textureSize(sea_displacement, int(level)).x;
  vec2 die = vec2(sea_die(), fract(5.0 * sea_die()));
  ivec2 point = ivec2(floor(place.xy * float(across) + die - 0.5)) & (across - 1);
  return texelFetch(sea_displacement, ivec3(point, int(place.z)), int(level)).w;
#else
  return textureLod(sea_displacement, place, level).w;
#endif
}

// Adds what a cascade has to the derivatives sx, sz, Dxx, Dzz and, for waves that can break, Dxx, Dzz, Dxz.
void add_cascade(int c, vec2 parameter, float size, inout vec4 sum, inout vec3 squeeze) {
  float level = sea_map_level_log2(c, size);
  float share = sea_map_share(level);
  vec3 place = sea_map_place(c, parameter);
#ifdef PICK_LEVELS
  level = sea_map_level_picked(level, sea_die());
#endif
  vec4 slopes = share * textureLod(sea_slopes, place, level);
  sum += slopes;
  // Ripples are too low for their shear to turn a slope.
  if (c < kMostBreaking) {
    float sheared = share * sea_shear(place, level);
    squeeze += float(c) < ocean.foam.z ? vec3(slopes.zw, sheared) : vec3(0.0);
  }
}

// `parameter`: the water at rest (m, relative to the camera); `footprint`: m; `gust`: what the local wind
// does to the variance of ripples.
Surface read_surface(vec2 parameter, float footprint, float gust) {
  float size = log2(footprint);
  vec4 sum = vec4(0.0);
  vec3 squeeze = vec3(0.0);  // Dxx, Dzz, Dxz
  // One by one, not in a loop, which some compilers leave as it is: constant indices are cheaper.
  add_cascade(0, parameter, size, sum, squeeze);
  if (CASCADES > 1) add_cascade(1, parameter, size, sum, squeeze);
  if (CASCADES > 2) add_cascade(2, parameter, size, sum, squeeze);
  if (CASCADES > 3) add_cascade(3, parameter, size, sum, squeeze);
  if (CASCADES > 4) add_cascade(4, parameter, size, sum, squeeze);
#ifdef RIPPLES
  sum.xy += sqrt(gust) * ripples(CASCADES - 1, parameter, size);
#endif
  Surface surface;
  surface.slope = surface_slope(sum.x, sum.y, sum.z, sum.w, squeeze.z);
  surface.jacobian = surface_jacobian(squeeze.x, squeeze.y, squeeze.z);
#ifdef PICK_LEVELS
  vec4 missing = sea_missing_picked(size, sea_die());
#else
  vec4 missing = sea_missing(size);
#endif
  surface.unresolved = missing.w;
  surface.covariance = gust * missing.xyz;
  return surface;
}
