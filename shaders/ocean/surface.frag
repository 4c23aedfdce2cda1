// The sea as an eye sees it: reflected sky, glitter of sun and moon, light from the water below, light
// through crests, and foam. What a pixel cannot resolve of the waves is their slope covariance, and
// everything here is a mean over the facets that this covariance describes.
#include "shared/frame.h"
#include "shared/ocean.h"
#include "lib/water.glsl"
#include "sky/sky.glsl"
#include "sky/probe.glsl"
#include "ocean/surface.glsl"

layout(location = 0) out vec4 colour;
layout(binding = 2) uniform sampler2D foam_pattern;  // evenly distributed over 0 … 1
layout(binding = 3) uniform sampler2D sea_seen;      // see mesh.frag

// Open Atlantic water, a little green of plankton: absorption and backscattering in 1/m by linear RGB
// (pure water of Pope & Fry 1997 and Morel 1974 plus chlorophyll 0.4 mg/m^3 after Morel & Maritorena
// 2001, averaged over the primaries).
const vec3 kAbsorption = vec3(0.350, 0.068, 0.046);
const vec3 kBackscatter = vec3(0.0024, 0.0036, 0.0050);
const float kFoamAlbedo = 0.55;  // fresh whitecaps, Koepke 1984

struct Surface {
  vec2 slope;       // mean slope in the pixel, in space
  vec3 covariance;  // of the slopes within the pixel: xx, zz, xz
  float jacobian;    // of the summed waves of foam size and longer
  float unresolved;  // variance of the Jacobian that this leaves out
};

Surface read_surface(vec2 parameter, float footprint) {
  vec4 sum = vec4(0.0);
  vec3 squeeze = vec3(0.0);  // Dxx, Dzz, Dxz of waves long enough to break
  float cross_term = 0.0, shown = 0.0;
  vec3 resolved = vec3(0.0);
  int cascades = int(ocean.water.y);
  for (int c = 0; c < cascades; ++c) {
    float level = sea_map_level(c, footprint);
    float share = sea_map_share(level);
    if (share <= 0.0) break;  // the cascades that follow are finer still
    vec3 place = sea_map_place(c, parameter);
    vec4 slopes = share * textureLod(sea_slopes, place, level);
    float mixed = share * textureLod(sea_displacement, place, level).w;
    sum += slopes;
    cross_term += mixed;
    float breaks = ocean.grid[c].w;
    squeeze += breaks * vec3(slopes.zw, mixed);
    float entry = min(level, float(kOceanMapLevels - 1));
    int first = c * kOceanMapLevels + min(int(entry), kOceanMapLevels - 2);
    vec4 kept = share * share *
                mix(ocean.resolved[first], ocean.resolved[first + 1], entry - floor(entry));
    resolved += kept.xyz;
    shown += breaks * kept.w;
  }
  Surface surface;
  surface.jacobian = surface_jacobian(squeeze.x, squeeze.y, squeeze.z);
  surface.slope = surface_slope(sum.x, sum.y, sum.z, sum.w, cross_term);
  surface.covariance = max(ocean.variance.xyz - resolved, vec3(4.0e-4, 4.0e-4, -1.0));
  float bound = 0.9 * sqrt(surface.covariance.x * surface.covariance.y);
  surface.covariance.z = clamp(surface.covariance.z, -bound, bound);
  surface.unresolved = max(ocean.foam.z - shown, 0.0) * ocean.foam.y;
  return surface;
}

float variance_along(vec3 covariance, vec2 direction) {
  return dot(direction * direction, covariance.xy) +
         2.0 * direction.x * direction.y * covariance.z;
}

// Light of a disc mirrored by the facets that happen to face half way (Cox & Munk 1954; the mean over
// facets after Ross, Dion & Potvin 2005): radiance = E F p / (4 n_y^4 area).
vec3 glitter(Surface surface, vec3 view, float shown_area, vec3 light, vec3 illuminance) {
  vec3 half_way = normalize(view + light);
  vec2 slope = -half_way.xz / max(half_way.y, 1.0e-3) - surface.slope;
  float density = slope_density(slope, surface.covariance.x, surface.covariance.y,
                                surface.covariance.z);
  // What of the facets the light can reach between the waves.
  float across = length(light.xz);
  vec2 toward = light.xz / max(across, 1.0e-4);
  float level = light.y - dot(surface.slope, light.xz);
  Facets lit = visible_facets(level, across * sqrt(variance_along(surface.covariance, toward)));
  float reach = clamp(level / max(lit.area, 1.0e-4), 0.0, 1.0);
  float ny2 = half_way.y * half_way.y;
  return illuminance * (fresnel_water(clamp(dot(view, half_way), 0.0, 1.0)) * density * reach /
                        (4.0 * max(ny2 * ny2, 1.0e-3) * max(shown_area, 1.0e-3)));
}

void main() {
  vec4 seen = texelFetch(sea_seen, ivec2(gl_FragCoord.xy), 0);
  if (seen.w <= 0.0) discard;
  vec2 parameter = seen.xy;
  float distance = seen.w;
  vec4 way = frame.relative_from_clip *
             vec4(2.0 * gl_FragCoord.xy * frame.viewport.zw - 1.0, 1.0, 1.0);
  vec3 view = -normalize(way.xyz / way.w);
  // Above the mean sea level, over the curved earth.
  float height = frame.camera.y - distance * view.y +
                 distance * distance * dot(view.xz, view.xz) / kTwiceEarthRadius;
  Surface surface = read_surface(parameter, seen.z);

  float across = length(view.xz);
  vec2 toward = view.xz / max(across, 1.0e-4);
  float sigma = sqrt(variance_along(surface.covariance, toward));
  float tilt = -dot(surface.slope, toward);  // mean slope toward the eye
  Facets facets = visible_facets(view.y + across * tilt, across * sigma);

  // The mean of the facets in sight leans toward the eye; it mirrors sky well above the horizon, which
  // is why a far sea is darker than the sky it meets.
  vec2 slope = surface.slope - toward * (sigma * facets.slope);
  vec3 normal = normalize(vec3(-slope.x, 1.0, -slope.y));
  float cosine = clamp(dot(view, normal), 0.02, 1.0);
  float reflectance = fresnel_water(cosine);
  vec3 mirrored = reflect(-view, normal);
  float below = clamp(-4.0 * mirrored.y, 0.0, 1.0);  // other waves instead of sky
  // The facets of this pixel as a rough mirror: the GGX width of their mean variance.
  float width = sqrt(surface.covariance.x + surface.covariance.y);
  vec3 sky_light = probe_radiance(normalize(vec3(mirrored.x, abs(mirrored.y) + 0.01, mirrored.z)),
                                  sqrt(min(width, 1.0)));

  vec3 up = normalize(vec3(-surface.slope.x, 1.0, -surface.slope.y));
  float sun_level = max(frame.sun_direction.y, 0.0);
  vec3 sun = frame.sun_illuminance.rgb, moon = frame.moon_illuminance.rgb;
  vec3 from_sky = frame.sky_illuminance.rgb;
  vec3 down = from_sky + sun * sun_level + moon * max(frame.moon_direction.y, 0.0);

  // Light that has been below: irradiance reflectance .33 bb / (a + bb) (Gordon et al. 1975) and the
  // way through the surface and back, .54.
  vec3 body = 0.54 * 0.33 * kBackscatter / (kAbsorption + kBackscatter) * down / kWaterPi;
  // Thin water near crests lets light through: the path through it shortens with height above the
  // troughs, and most of it comes from behind, toward the light.
  float crest = clamp(0.5 + height / max(ocean.water.x, 0.3), 0.0, 1.5);
  float away = max(dot(-view, normalize(vec3(frame.sun_direction.x, 0.25, frame.sun_direction.z))), 0.0);
  float steep = clamp(length(surface.slope) * 1.8, 0.0, 1.0);
  float path = mix(9.0, 1.2, clamp(crest * steep, 0.0, 1.0));
  vec3 through = exp(-(kAbsorption + 30.0 * kBackscatter) * path);
  body += through * (sun * (0.010 * away * away) + from_sky * 0.006) * crest * steep;

  float mean_reflectance = mix(reflectance, reflectance * 0.6, below);
  vec3 radiance = sky_light * (reflectance * (1.0 - 0.55 * below)) + body * (1.0 - mean_reflectance);
  // The brighter of the two lights: while the sun is up the moon's glitter is lost in it.
  bool by_day = sun.g >= moon.g;
  radiance += glitter(surface, view, facets.area,
                      by_day ? frame.sun_direction.xyz : frame.moon_direction.xyz,
                      by_day ? sun : moon);

  // Foam where the summed surface is squeezed below what the wind's share of white water asks for; what
  // is too fine for the pixel, or for foam, is the part of the Jacobian's distribution below that, so
  // a far sea keeps the same share of white. A pattern that drifts with the water breaks it up.
  float spread = sqrt(surface.unresolved + ocean.foam.w);
  float coverage = normal_below((ocean.foam.x - surface.jacobian) / spread);
  vec2 along = ocean.foam_grid.zw;
  vec2 at = ocean.foam_grid.xy + vec2(dot(along, parameter), ocean.foam_stretch.x *
            (along.x * parameter.y - along.y * parameter.x));
  float fineness = log2(max(seen.z * length(along) * ocean.foam_stretch.y, 1.0e-6));
  float pattern = 0.5 * (textureLod(foam_pattern, at, fineness).r +
                         textureLod(foam_pattern, 2.7 * at.yx, fineness + 1.4).r);
  // The mean of two even distributions is triangular: even it out again.
  pattern = pattern < 0.5 ? 2.0 * pattern * pattern : 1.0 - 2.0 * (1.0 - pattern) * (1.0 - pattern);
  // A thin veil, and inside it the thick white of what breaks now.
  vec2 edge = vec2(1.0) - coverage * vec2(1.0, 0.6);
  vec2 softness = vec2(min(0.2, coverage));
  vec2 layers = smoothstep(edge - softness, edge + softness, vec2(pattern));
  float foam = mix(dot(layers, vec2(0.45, 0.55)), 0.8 * coverage, smoothstep(40.0, 250.0, distance));
  vec3 white = kFoamAlbedo / kWaterPi *
               (sun * max(dot(up, frame.sun_direction.xyz), 0.0) + from_sky * (0.5 + 0.5 * up.y) +
                moon * max(dot(up, frame.moon_direction.xyz), 0.0));
  radiance = mix(radiance, white, clamp(foam, 0.0, 1.0));

  AirLight air = air_light(-view, distance);
  radiance = radiance * air.transmittance + air.inscattered;
  colour = vec4(max(radiance, vec3(0.0)) * frame.time.z, 1.0);
}
