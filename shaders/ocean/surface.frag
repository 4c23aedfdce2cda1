// The sea as an eye sees it: reflected sky, glitter of sun and moon, light from the water below, light
// through crests, a hull under the surface, and foam. What a pixel cannot resolve of the waves is their
// slope covariance, and everything here is a mean over the facets that this covariance describes.
#include "shared/frame.h"
#include "shared/ocean.h"
#include "lib/water.glsl"
#include "sky/probe.glsl"
#include "clouds/shadow.glsl"
#ifdef HULL_SHADOW
#include "boat/shadow.glsl"
#endif
#include "ocean/surface.glsl"
#ifdef PICK_LEVELS
#include "ocean/die.glsl"
#endif
#include "ocean/foam.glsl"
#include "ocean/glints.glsl"
#include "ocean/air.glsl"

layout(location = 0) in vec3 way;  // see surface.vert
layout(location = 1) flat in vec4 light_time;
layout(location = 2) flat in vec4 direct_exposure;
layout(location = 3) flat in vec4 diffuse_height;
layout(location = 4) flat in vec4 haze;
layout(location = 0) out vec4 colour;
layout(binding = 3) uniform sampler2D sea_seen;  // see mesh.frag
#ifdef HULL
layout(binding = 5) uniform sampler2D dry;   // see mesh.frag
layout(binding = 6) uniform sampler2D hull;  // the picture so far
#endif
layout(binding = 4) uniform sampler2D horizon_sky;  // see air.frag
layout(binding = OFFING_UNIT_GUSTS) uniform sampler2D gusts;
layout(binding = OFFING_UNIT_SQUALLS) uniform sampler2D squalls;

const int kMostBreaking = min(CASCADES, 2);  // cascades whose waves can be long enough to break
const float kFoamAlbedo = 0.55;  // fresh whitecaps, Koepke 1984

struct Surface {
  vec2 slope;       // mean slope in the pixel, in space
  vec3 covariance;  // of the slopes within the pixel: xx, zz, xz
};

// Adds what a cascade has to the derivatives: sx, sz, Dxx, Dzz, and Dxz.
void add_cascade(int c, vec2 parameter, float size, inout vec4 sum, inout float cross_term) {
  float level = sea_map_level_log2(c, size);
  float share = sea_map_share(level);
  vec3 place = sea_map_place(c, parameter);
#ifdef PICK_LEVELS
  level = sea_map_level_picked(level, sea_die());
#endif
  sum += share * textureLod(sea_slopes, place, level);
  // Ripples are too low for their shear to turn a slope.
  if (c < kMostBreaking) {
    cross_term += (float(c) < ocean.foam.z ? share : 0.0) *
                  textureLod(sea_displacement, place, level).w;
  }
}

Surface read_surface(vec2 parameter, float footprint) {
  float size = log2(footprint);
  vec4 sum = vec4(0.0);
  float cross_term = 0.0;
  // One by one, not in a loop, which some compilers leave as it is: constant indices are cheaper.
  add_cascade(0, parameter, size, sum, cross_term);
  if (CASCADES > 1) add_cascade(1, parameter, size, sum, cross_term);
  if (CASCADES > 2) add_cascade(2, parameter, size, sum, cross_term);
  if (CASCADES > 3) add_cascade(3, parameter, size, sum, cross_term);
  if (CASCADES > 4) add_cascade(4, parameter, size, sum, cross_term);
  Surface surface;
  surface.slope = surface_slope(sum.x, sum.y, sum.z, sum.w, cross_term);
  // Ripples answer a gust at once, and steeply: their growth goes with the square of the wind's pull
  // (Plant 1982), so do the cat's paws that sailors look for.
  float gust = 1.0 + ocean.gust.w * textureLod(gusts, ocean.gust.xy + parameter * ocean.gust.z, 0.0).r;
  for (int i = 0; i < int(ocean.squall.w); ++i) {  // under rain
    gust += textureLod(squalls, ocean.squall.xy + parameter * ocean.squall.z, 0.0).r;
  }
  surface.covariance = sea_missing(size).xyz * clamp(gust * gust * gust, 0.2, 3.0);
  return surface;
}

float variance_along(vec3 covariance, vec2 direction) {
  return dot(direction * direction, covariance.xy) +
         2.0 * direction.x * direction.y * covariance.z;
}

// Light of a disc mirrored by the facets that happen to face half way (Cox & Munk 1954; the mean over
// facets after Ross, Dion & Potvin 2005): radiance = E F p / (4 n_y^4 area).
vec3 glitter(Surface surface, vec3 view, float shown_area, vec3 light, vec3 illuminance,
             vec2 parameter, float size) {
  vec3 sum = view + light;
  float length2 = dot(sum, sum);
  vec3 half_way = sum * inversesqrt(length2);
  float cosine = 0.5 * sqrt(length2);
  vec2 slope = -half_way.xz / max(half_way.y, 1.0e-3) - surface.slope;
  float density = slope_density(slope, surface.covariance.x, surface.covariance.y,
                                surface.covariance.z);
  // What of the facets the light can reach between the waves.
  float level = light.y - dot(surface.slope, light.xz);
  float reach = level > 0.0 ? visible_share(level, sqrt(variance_along(surface.covariance, light.xz)))
                            : 0.0;
  float ny2 = half_way.y * half_way.y;
  density *= glint(parameter, size, density, light_time.w);
  return illuminance * (fresnel_water(clamp(cosine, 0.0, 1.0)) * density * reach /
                        (4.0 * max(ny2 * ny2, 1.0e-3) * max(shown_area, 1.0e-3)));
}

// Radiance of the water that a pixel sees (mesh.frag).
vec3 sea_radiance(vec4 seen) {
  vec2 parameter = seen.xy;
  float distance = seen.w;
  vec3 view = -normalize(way);
  // Above the mean sea level, over the curved earth.
  float height = diffuse_height.w - distance * view.y +
                 distance * distance * dot(view.xz, view.xz) / kTwiceEarthRadius;
  Surface surface = read_surface(parameter, seen.z);

  vec3 light = light_time.xyz;
  vec3 direct = direct_exposure.rgb * cloud_shadow(-view * distance);
#ifdef HULL_SHADOW
  for (int i = 0; i < int(boat_shadow_reaches(boat_shadow_place(-view * distance))); ++i) {
    direct *= boat_shade(-view * distance);
  }
#endif
  vec3 from_sky = diffuse_height.rgb;
  vec3 down = from_sky + direct * max(light.y, 0.0);
  vec3 radiance;

  float across = length(view.xz);
  vec2 toward = view.xz / max(across, 1.0e-4);
  float sigma = sqrt(variance_along(surface.covariance, toward));
  float tilt = -dot(surface.slope, toward);  // mean slope toward the eye
  Facets facets = visible_facets(view.y + across * tilt, across * sigma);

  // The mean of the facets in sight leans toward the eye; it mirrors sky well above the horizon, which
  // is why a far sea is darker than the sky it meets.
  vec2 slope = surface.slope - toward * (sigma * facets.slope);
  vec3 normal = vec3(-slope.x, 1.0, -slope.y) * inversesqrt(1.0 + dot(slope, slope));
  float cosine = clamp(dot(view, normal), 0.02, 1.0);
  float reflectance = fresnel_water(cosine);
  vec3 mirrored = 2.0 * dot(view, normal) * normal - view;
  float below = clamp(-4.0 * mirrored.y, 0.0, 1.0);  // other waves instead of sky
  // The facets of this pixel as a rough mirror: the GGX width of their mean variance.
  float width = sqrt(surface.covariance.x + surface.covariance.y);
  vec3 sky_light = probe_radiance(vec3(mirrored.x, max(abs(mirrored.y), 0.01), mirrored.z),
                                  sqrt(min(width, 1.0)));

  // Light that has been below.
  vec3 body = ocean.body.rgb * down;
  // Thin water near crests lets light through: the path through it shortens with height above the
  // troughs, and most of it comes from behind, toward the light.
  float steepness = length(surface.slope);
  float crest = clamp(0.5 + height / max(ocean.water.x, 0.3), 0.0, 1.5) *
                clamp(1.8 * steepness, 0.0, 1.0);
  float away = max(-dot(view.xz, light.xz) - 0.25 * view.y, 0.0);
  float thin = clamp(crest, 0.0, 1.0);
  vec3 through = mix(ocean.crest_thick.rgb, ocean.crest_thin.rgb, thin * thin);
  body += through * (direct * (0.010 * away * away) + from_sky * 0.006) * crest;

#ifdef HULL
  // A hull under the surface, through the water before it and bent by its slope.
  vec2 sides = texelFetch(dry, ivec2(gl_FragCoord.xy), 0).xy;
  float water = sides.x > 0.0 ? 1.0 / sides.x - distance : 0.0;
  for (int i = 0; i < int(water > 0.0 && water < 8.0); ++i) {
    vec2 shift = surface.slope * (0.5 * min(water, 1.0) / (frame.camera.w * max(distance, 1.0)));
    ivec2 at = ivec2(clamp(gl_FragCoord.xy + shift, vec2(0.0), frame.viewport.xy - 1.0));
    vec3 lost = exp(-(ocean.absorption.rgb + 12.0 * ocean.backscatter.rgb) * (2.0 * water));
    body = mix(body, texelFetch(hull, at, 0).rgb / direct_exposure.w, lost);
  }
#endif

  radiance = sky_light * (reflectance * (1.0 - 0.55 * below)) +
             body * (1.0 - reflectance * (1.0 - 0.4 * below));
  radiance += glitter(surface, view, facets.area, light, direct, parameter, seen.z);

  float up = inversesqrt(1.0 + steepness * steepness);
  vec3 white = kFoamAlbedo / kWaterPi *
               (direct * max((light.y - dot(surface.slope, light.xz)) * up, 0.0) +
                from_sky * (0.5 + 0.5 * up));
  radiance = mix(radiance, white, sea_foam(parameter, seen.z));

  // Air that fills the view to the horizon looks as the horizon does.
  vec3 clear = exp(-haze.rgb * distance);
  vec3 horizon = textureLod(horizon_sky, vec2(horizon_place(-view.xz), 0.5), 0.0).rgb;
  radiance = mix(horizon, radiance, clear);
  return max(radiance, vec3(0.0));
}

void main() {
  vec4 seen = texelFetch(sea_seen, ivec2(gl_FragCoord.xy), 0);
  if (seen.w <= 0.0) discard;
  colour = vec4(sea_radiance(seen) * direct_exposure.w, 1.0);
}
