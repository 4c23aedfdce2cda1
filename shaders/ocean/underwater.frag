// The view from the water: what lies in it, the surface from below with the sky through it, and the water
// itself, with shafts of light where the waves gather it. Dry pixels are left as they are, but for the
// edge of the water that climbs the lens.
#include "shared/frame.h"
#include "shared/ocean.h"
#include "sky/sky.glsl"
#include "sky/probe.glsl"
#include "ocean/surface.glsl"
#define STREAKS
#include "ocean/foam.glsl"
#include "ocean/underwater.glsl"
#include "ocean/ripples.glsl"
#include "ocean/surface_below.glsl"
#include "lib/tonemap.glsl"

layout(binding = 3) uniform sampler2D sea_below;  // see underwater_split.frag
layout(binding = 4) uniform sampler2D relit;      // see underwater_relight.frag
#ifdef CROSSING
layout(binding = 5) uniform sampler2D beyond;     // see underwater_split.frag
#endif
layout(location = 0) out vec4 colour;

// What lies along a bent or mirrored ray, as far as it is in the picture: a boat, above the surface
// (`side` 1) or under it (-1). w: how far along, 0 for nothing.
vec4 solid_along(vec3 from, vec3 direction, float side) {
  vec4 found = vec4(0.0);
  float along = 0.15, before = 0.0;
  for (int i = 0; i < 14 * int(water.above.w); ++i) {
    vec3 place = from + direction * along;
    vec4 clip = frame.clip_from_relative * vec4(place, 1.0);
    vec2 at = (clip.xy / max(clip.w, 1.0e-3) * 0.5 + 0.5) * frame.viewport.xy;
    bool in_view = clip.w > 0.05 && all(greaterThan(at, vec2(0.0))) &&
                   all(lessThan(at, frame.viewport.xy));
    ivec2 pixel = ivec2(clamp(at, vec2(0.0), frame.viewport.xy - 1.0));
    vec4 thing = texelFetch(relit, pixel, 0);
    float surface = texelFetch(sea_below, pixel, 0).w;
    bool right_side = side > 0.0 ? surface > 0.0 && thing.w > surface
                                 : surface <= 0.0 || thing.w < surface;
    float past = length(place) - thing.w;
    if (in_view && right_side && thing.w > 0.0 && past > 0.0 && past < 2.5 * (along - before) + 0.4) {
      found = vec4(thing.rgb, along);
      break;
    }
    before = along;
    along *= 1.38;
  }
  return found;
}

vec3 surface_from_below(Daylight day, vec3 direction, vec2 parameter, float footprint, float s) {
  Underside under = read_underside(parameter, footprint);
  vec2 toward = direction.xz / max(length(direction.xz), 1.0e-4);
  float sigma = sqrt(max(dot(toward * toward, under.covariance.xy) +
                         2.0 * toward.x * toward.y * under.covariance.z, 0.0));
  vec3 normal = normalize(vec3(-under.slope.x, 1.0, -under.slope.y));
  float cosine = clamp(dot(direction, normal), 0.02, 1.0);
  // Near by, an eye sees one by one most of the ripples that the maps lack: as blur they would be too
  // soft by half.
  Window window = window_through(cosine, 0.4 * sigma);
  float passing = window.passing;
  vec3 sum = through_facets(direction, normal, window, 0.4 * sigma);
  vec3 mirrored = direction - 2.0 * cosine * normal;
  sum += depths(day, mirrored) * (1.0 - passing);

  // Sun or moon through the facets that bend them here.
  BentGlitter g = bent_glitter(-direction, water.above.xyz);
  float density = slope_density(g.slope - under.slope, under.covariance.x, under.covariance.y,
                                under.covariance.z);
  sum += bright_light() * (g.radiance * density);

  // The boat, above through the window or below mirrored by the surface.
  vec3 place = direction * s;
  float out2 = 1.0 - kWaterIndex * kWaterIndex * (1.0 - cosine * cosine);
  bool through = passing > 0.5;
  vec3 bent = kWaterIndex * direction + (sqrt(max(out2, 0.0)) - kWaterIndex * cosine) * normal;
  vec4 boat = solid_along(place, through ? bent : mirrored, through ? 1.0 : -1.0);
  vec3 seen = boat.rgb / frame.time.z;
  if (through) {
    seen *= kWaterIndex * kWaterIndex;
  } else {
    PathLight path = path_light(day, 0.5 * boat.w, mirrored, boat.w);
    seen = seen * exp(-water.beam.rgb * boat.w) + path.from_sky + path.from_light;
  }
  float share = through ? passing : 1.0 - passing;
  vec3 behind = through ? sum : depths(day, mirrored) * share;
  sum = boat.w > 0.0 ? (through ? seen * share : sum - behind + seen * share) : sum;

  // Bubbles let a third of the daylight through, from all sides (Koepke 1984: they send back .55).
  vec3 white = 0.35 * (day.direct + day.diffuse) / kWaterPi;
  return mix(sum, white, under.foam);
}

// Gathered light along the way, over its mean, at a few places. Each stands for the water up to the next:
// a long step across the beams sees their mean, one along them sees them sharp.
float shafts(vec3 direction, float s, float depth) {
  const int kSteps = STEPS;
  const float kReach = 14.0;
  float reach = min(s, kReach);
  float k = water.beam.g - water.diffuse.g * direction.y;
  float start = dither(gl_FragCoord.xy) * 128.0 + 0.5;
  float across = length(direction.xz - water.light.xz * (direction.y / water.light.y));
  float sum = 0.0, weights = 1.0e-6;
  for (int i = 0; i < kSteps * int(water.bright.w > 0.0); ++i) {
    float t = (float(i) + start) / float(kSteps);
    float along = reach * t * t;
    float weight = t * exp(-k * along);
    vec3 place = direction * along;
    float under = max(depth - place.y, 0.0);
    sum += weight * caustic(place, under, across * 2.0 * reach * t / float(kSteps));
    weights += weight;
  }
  // What lies beyond shines evenly.
  float near = (1.0 - exp(-k * reach)) / max(1.0 - exp(-k * min(s, kFarAway)), 1.0e-4);
  return mix(1.0, sum / weights, weights > 1.0e-5 ? clamp(near, 0.0, 1.0) : 0.0);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 seen = texelFetch(sea_below, pixel, 0);
  vec4 thing = texelFetch(relit, pixel, 0);
  vec4 way = frame.relative_from_clip *
             vec4(2.0 * gl_FragCoord.xy * frame.viewport.zw - 1.0, 1.0, 1.0);
  vec3 direction = normalize(way.xyz / way.w);
  float edge = 1.0;
#ifdef CROSSING
  // Water stands up on glass by about the capillary length, 2.7 mm, and bends the light away.
  float climbed = texelFetch(beyond, pixel, 0).r;
  edge = mix(0.3, 1.0, smoothstep(0.0, 0.0027, abs(climbed)));
  if (seen.w == 0.0) {
    if (edge >= 1.0) discard;
    colour = vec4(thing.rgb * edge, 1.0);
    return;
  }
#else
  seen.w = seen.w > 0.0 ? seen.w : -1.0;
#endif
  float depth = water.beam.w;
  Daylight day = daylight();
  float s = seen.w > 0.0 ? seen.w : kFarAway;
  bool is_thing = thing.w > 0.0 && thing.w < s;
  s = is_thing ? thing.w : s;

  vec3 radiance = is_thing ? thing.rgb / frame.time.z : vec3(0.0);
  bool is_surface = seen.w > 0.0 && !is_thing;
  for (int i = 0; i < int(is_surface); ++i) {
    radiance = surface_from_below(day, direction, seen.xy, abs(seen.z), s);
  }
  radiance *= exp(-water.beam.rgb * s);
  PathLight path = path_light(day, depth, direction, s);
  radiance += path.from_sky + path.from_light * shafts(direction, s, depth);
  colour = vec4(min(max(radiance, vec3(0.0)) * (frame.time.z * edge), vec3(3.0e4)), 1.0);
}
