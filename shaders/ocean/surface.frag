// The sea as an eye sees it: reflected sky, glitter of sun and moon, light from the water below, light
// through crests, a hull under the surface, and foam. What a pixel cannot resolve of the waves is their
// slope covariance, and everything here is a mean over the facets that this covariance describes.
#include "shared/frame.h"
#include "shared/ocean.h"
#include "lib/crest.glsl"
#include "lib/water.glsl"
#include "sky/probe.glsl"
#include "clouds/shadow.glsl"
#include "ocean/die.glsl"
#include "ocean/surface.glsl"
#ifdef HULL_SHADOW
#include "boat/shadow.glsl"
#include "ocean/hull_shade.glsl"
#endif
#include "ocean/ripples.glsl"
#include "ocean/resolved.glsl"
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
#ifdef SQUALLS
layout(binding = OFFING_UNIT_SQUALLS) uniform sampler2D squalls;
#endif

const float kFoamAlbedo = 0.55;  // fresh whitecaps, Koepke 1984
const float kBackSlope = 0.3;     // of a steep wave's far side
const float kPlumeAlbedo = 0.12;  // of clouds of bubbles under them (by eye)

// Ripples answer a gust at once, and steeply: their growth goes with the square of the wind's pull (Plant
// 1982), so do the cat's paws that sailors look for. What the wind does to their variance.
float gustiness(vec2 parameter) {
  vec2 place = ocean.gust.xy + parameter * ocean.gust.z;
#ifdef PICK_LEVELS
  ivec2 texel = ivec2(floor(place * float(kGustTexels) + (sea_die() - 0.5)));
  float field = texelFetch(gusts, texel & (kGustTexels - 1), 0).r;
#else
  float field = textureLod(gusts, place, 0.0).r;
#endif
  float gust = 1.0 + ocean.gust.w * field;
#ifdef SQUALLS
  gust += textureLod(squalls, ocean.squall.xy + parameter * ocean.squall.z, 0.0).r;  // under rain
#endif
  return clamp(gust * gust * gust, 0.2, 3.0);
}

float variance_along(vec3 covariance, vec2 direction) {
  return dot(direction * direction, covariance.xy) +
         2.0 * direction.x * direction.y * covariance.z;
}

// What is smooth, low reads by chance from one texel: the mean is that of a straight line between them.
vec3 horizon_radiance(vec2 heading) {
  float place = horizon_place(heading);
#ifdef PICK_LEVELS
  int texel = int(place * float(kHorizonTexels) + sea_die() - 0.5 + float(kHorizonTexels));
  return texelFetch(horizon_sky, ivec2(texel & (kHorizonTexels - 1), 0), 0).rgb;
#else
  return textureLod(horizon_sky, vec2(place, 0.5), 0.0).rgb;
#endif
}
vec3 sky_mirrored(vec3 direction, float roughness) {
#ifdef PICK_LEVELS
  return probe_radiance_picked(direction, roughness, sea_die());
#else
  return probe_radiance(direction, roughness);
#endif
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

// Light that has come through a crest from behind: radiance before Fresnel's share of the near face. It
// enters by the far side, whose slope is kBackSlope, is lost on its way through the crest and, scattered, on the
// view's ray behind the face, along which it comes from ever farther:
//   L = E cos i / cos t  p(turn)  b / (2 K)  exp(-K way) / n^2.
// The turn is that between both refracted rays: gentle faces look down into the water, away from the beam;
// steep ones toward it, and glow.
vec3 through_crest(vec2 slope, vec3 view, vec3 light, vec3 direct, vec3 from_sky, float height) {
  vec2 ahead = light.xz / max(length(light.xz), 1.0e-3);
  vec3 front = vec3(-slope.x, 1.0, -slope.y) * inversesqrt(1.0 + dot(slope, slope));
  vec3 back = vec3(ahead.x * kBackSlope, 1.0, ahead.y * kBackSlope) *
              inversesqrt(1.0 + kBackSlope * kBackSlope);
  vec3 seen = refract(-view, front, 1.0 / kWaterIndex);
  vec3 beam = refract(-light, back, 1.0 / kWaterIndex);
  float lit = max(dot(light, back), 0.0) / max(-dot(beam, back), 0.1);  // of a plane across the beam
  // Width of the crest at this height: no crest stands much over .55 Hs.
  float below_top = max(0.55 * ocean.water.x - height, 0.05);
  float width = below_top * (1.0 / max(-dot(slope, view.xz), 0.1) + 1.0 / kBackSlope);
  width = min(width, 60.0);
  vec3 left = exp(-ocean.crest_loss.rgb * width);
  float toward = clamp(-4.0 * dot(view.xz, ahead), 0.0, 1.0);  // the light is beyond the crest
  float turned = crest_turned_again(ocean.crest_loss.w * width) * sea_water_phase(-dot(beam, seen)) * lit * toward;
  return left * ocean.crest_gain.rgb * (direct * turned + from_sky * 0.012);
}

// Radiance of the water that a pixel sees (mesh.frag).
vec3 sea_radiance(vec4 seen) {
  vec2 parameter = seen.xy;
  float distance = seen.w;
  vec3 view = -normalize(way);
  // Above the mean sea level, over the curved earth.
  float height = diffuse_height.w - distance * view.y +
                 distance * distance * dot(view.xz, view.xz) / kTwiceEarthRadius;
  Surface surface = read_surface(parameter, seen.z, gustiness(parameter));

  vec3 light = light_time.xyz;
  vec3 water = -view * distance;
  vec3 direct = direct_exposure.rgb;
#ifdef CLOUDS
  direct *= cloud_shadow(water);
#endif
  vec3 into = direct;  // the part of it that lights what lies deep
#ifdef HULL_SHADOW
  into *= hull_shade_below(water, view, light);
  direct *= boat_shade(water);
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
  vec3 sky_light = sky_mirrored(vec3(mirrored.x, max(abs(mirrored.y), 0.01), mirrored.z),
                                sqrt(min(width, 1.0)));

  // Light that has been below.
  vec3 body = ocean.body.rgb * (from_sky + into * max(light.y, 0.0));
  float steepness = length(surface.slope);
  body += through_crest(surface.slope, view, light, direct, from_sky, height);

  // Bubbles that breaking water has taken down with it, seen through a metre of water: pale green.
  Foam foam = sea_foam(parameter, seen.z, surface.jacobian, surface.unresolved);
  body += down * ocean.plume.rgb * (kPlumeAlbedo / kWaterPi * min(1.3 * foam.plume, 1.0));

#ifdef HULL
  // A hull under the surface, through the water before it and bent by its slope.
  vec2 sides = texelFetch(dry, ivec2(gl_FragCoord.xy), 0).xy;
  float depth = sides.x > 0.0 ? 1.0 / sides.x - distance : 0.0;
  if (depth > 0.0 && depth < 8.0) {
    vec2 shift = surface.slope * (0.5 * min(depth, 1.0) / (frame.camera.w * max(distance, 1.0)));
    ivec2 at = ivec2(clamp(gl_FragCoord.xy + shift, vec2(0.0), frame.viewport.xy - 1.0));
    vec3 lost = exp(-ocean.hull_loss.rgb * (2.0 * depth));
    body = mix(body, texelFetch(hull, at, 0).rgb / direct_exposure.w, lost);
  }
#endif

  radiance = sky_light * (reflectance * (1.0 - 0.55 * below)) +
             body * (1.0 - reflectance * (1.0 - 0.4 * below));
  radiance += glitter(surface, view, facets.area, light, direct, parameter, seen.z);

  float up = inversesqrt(1.0 + steepness * steepness);
  // Foam is piled up where its lace is dense, and lit from that side.
  float lit = max((light.y - dot(surface.slope, light.xz)) * up, 0.0) * (1.0 + 0.12 * foam.relief);
  vec3 white = kFoamAlbedo / kWaterPi * (direct * max(lit, 0.0) + from_sky * (0.5 + 0.5 * up));
  radiance = mix(radiance, white, foam.opacity);

  // Air that fills the view to the horizon looks as the horizon does.
  vec3 clear = exp(-haze.rgb * distance);
  vec3 horizon = horizon_radiance(-view.xz);
  radiance = mix(horizon, radiance, clear);
  return max(radiance, vec3(0.0));
}

void main() {
  vec4 seen = texelFetch(sea_seen, ivec2(gl_FragCoord.xy), 0);
  if (seen.w <= 0.0) discard;
  colour = vec4(sea_radiance(seen) * direct_exposure.w, 1.0);
}
