// Light and transmittance of the clouds along one ray. Needs shared/frame.h before it.
#include "sky/sky.glsl"
#include "lib/phase_cloud.glsl"
#include "lib/cloud_scattering.glsl"
#include "clouds/density.glsl"
#include "clouds/shadow.glsl"
#include "clouds/air.glsl"

// The includer's quality: STEPS, SKIPS, FINEST (m), GROWTH (m per m of distance), REACH (m). What follows
// is only ever changed to measure what it buys.
#ifndef LEAST
#define LEAST 0.008
#endif
#ifndef LONGEST_SKIP  // 0: no longer steps through empty air
#define LONGEST_SKIP 4.0
#endif
#ifndef SHADOW_MAP  // 0: light steps alone
#define SHADOW_MAP 1
#endif
#ifndef PIXEL_ANGLE  // radians that one ray stands for
#define PIXEL_ANGLE frame.camera.w
#endif
const float kShows = 1.0e-3;  // share of the picture that is worth being lit
const float kLeast = LEAST;  // transmittance at which a ray has seen all that shows

// Of a heap, whose faces stand at all slants to the light: found by comparing with the path tracer
// (engine/clouds/LIGHT.md).
const float kHeapLeak = 0.4;     // k, per scaled mean free path
const float kHeapFacing = 0.25;  // cosine
const float kCleftHides = 0.6;   // of the light from all round
const float kTopsReflect = 0.5;  // of the light, where a layer of heaps is seen from above
const float kOthersReflect = 0.5;  // likewise, of what a neighbour's side sends to the shaded side of a heap
const float kSkyLook = 0.35;  // height at which each half of the sky is looked at, radians
const vec2 kHeapTakes = vec2(0.46, 0.72);  // of the light on a square across its way: of a flat one; what a high one adds

struct CloudSight {
  vec3 radiance;  // cd/m^2
  float transmittance;
  float distance;  // where its light comes from, in the mean (m)
};

// What does not change along a ray.
struct CloudRay {
  vec3 direction;
  vec3 low_light, high_light;  // lux of the light at the lowest base and at the highest top
  vec3 from_above, from_below; // mean radiance of sky and sea, cd/m^2
  vec3 lit_half, dim_half;  // radiance of the sky's half on the light's side and of the other, over their mean
  float cosine;   // to the light
  float phase;    // of light scattered once
  float blurred;  // of light that was bent forward before
  float g;        // mean cosine of a scattering
};

CloudRay cloud_ray(vec3 direction, float near) {
  CloudRay ray;
  ray.direction = direction;
  vec3 light = clouds.light_direction.xyz;
  // Far away the light stands at another height.
  vec3 at = direction * near;
  vec3 up = normalize(vec3(2.0 * at.x * clouds.eye.y, 1.0, 2.0 * at.z * clouds.eye.y));
  float level = dot(light, up);
  ray.low_light = cloud_light_at(1.0e-3 * clouds.layer.x, level, clouds.light_source.rgb);
  ray.high_light = cloud_light_at(1.0e-3 * clouds.layer.y, level, clouds.light_source.rgb);
  ray.cosine = dot(direction, light);
  vec3 sky_above = frame.sky_illuminance.rgb;
  ray.from_above = clouds.ambient.y * sky_above / kPhasePi;
  ray.from_below = ray.from_above * 0.08 + clouds.ambient.y * 0.05 / kPhasePi * ray.low_light * max(level, 0.0);
  // A low light leaves one half of the sky brighter and warmer: told from one look into each.
  vec2 toward = light.xz * inversesqrt(max(dot(light.xz, light.xz), 1.0e-8));
  const vec2 kLook = vec2(cos(kSkyLook), sin(kSkyLook));
  vec3 lit = sky_radiance(vec3(toward.x * kLook.x, kLook.y, toward.y * kLook.x));
  vec3 other = sky_radiance(vec3(-toward.x * kLook.x, kLook.y, -toward.y * kLook.x));
  vec3 share = lit / max(lit + other, vec3(1.0e-12));
  ray.lit_half = 2.0 * share;
  ray.dim_half = 2.0 - 2.0 * share;
  // Droplets of one diameter, or two lobes as in the sources.
  vec4 lobes = clouds.phase;
  ray.g = lobes.x * (1.0 - lobes.z) - lobes.y * lobes.z;
  ray.phase = dual_henyey_greenstein(lobes.x, -lobes.y, lobes.z, ray.cosine);
  for (int i = 0; i < int(clouds.march.y > 0.0); ++i) {
    DropletPhase droplets = droplet_phase(clouds.march.y);
    ray.g = droplet_mean_cosine(droplets);
    ray.phase = droplet_scattering_with_bows(droplets, droplet_bows(clouds.march.y, 0.55), ray.cosine);
  }
  ray.g = clamp(ray.g * lobes.w, 0.0, 0.9);
  ray.phase = mix(0.25 / kPhasePi, ray.phase, lobes.w);
#ifdef WIDE_PHASE  // where texels are wider than the forward peak its light is spread out, not lost
  ray.phase = henyey_greenstein(min(ray.g, 0.7), ray.cosine);
#endif
  ray.blurred = henyey_greenstein(pow(ray.g, kForwardBlur), ray.cosine);
  return ray;
}

// Optical depth between a place, where the signed field is `inside`, and the far side of its cloud, away from the
// light: of the cloud that ends soon by three samples, which are far finer than the map, and past them as though the
// field fell on as between the last two; of what goes on by the map, where there is one (of `map` y and z:
// cloud_shadow_depths).
float depth_beyond(CloudPlace from, float inside, vec3 p, vec3 map) {
  float way = 60.0 * clouds.form.w;
  float gone = 0.0, rest = 0.0, there = inside, fall = 0.0;
  for (int i = 0; i < 3; ++i) {
    gone += way;
    vec3 q = p - gone * clouds.light_direction.xyz;
    float next = cloud_body(cloud_place_beside(from, q), q, way) - kCloudMeanErosion * clouds.form.z;
    rest += way * cloud_mean_ramp(there, next, kCloudEdgeWidth);
    fall = (there - next) / way;
    there = next;
    way *= 2.0;
  }
  float on = clamp(there, 0.0, 1.0);
  const float kLongest = 2800.0;  // m of dense cloud, for a field of 1
  rest += min(kLongest * clouds.form.w * on, cloud_ramp_integral(there, kCloudEdgeWidth) / max(fall, 1.0e-7));
  return mix(clouds.layer.z * from.kind.extinction * rest, map.y, map.z * clamp(8.0 * on, 0.0, 1.0));
}

// Optical depths between such a place and both ends of the light's ray through it. x, toward the light: some steps
// that double, each with the mean between its ends as along the ray, and the shadow map beyond. y, on from the place.
vec2 depths_along_light(CloudPlace from, float inside, vec3 p, float footprint, int steps) {
  vec3 toward = clouds.light_direction.xyz;
  float step_length = 60.0 * clouds.form.w;
  float along = 0.0;
  float depth = 0.0;
  float before = inside;
  for (int i = 0; i < steps; ++i) {
    along += step_length;
    vec3 q = p + toward * along;
    CloudPlace place = cloud_place_beside(from, q);
    float there = cloud_body(place, q, max(footprint, 0.5 * step_length)) - kCloudMeanErosion * clouds.form.z;
    depth += step_length * clouds.layer.z * place.kind.extinction * cloud_filling(place.x) *
             cloud_mean_ramp(before, there, kCloudEdgeWidth);
    before = there;
    step_length *= 2.0;
  }
  vec3 map = vec3(0.0);
  for (int i = 0; i < min(steps, SHADOW_MAP); ++i) {
    map = cloud_shadow_depths(p + toward * along, cloud_altitude(p));
    depth += map.x * map.z;
  }
  return vec2(depth, depth_beyond(from, inside, p, map));
}

// Light leaving a place toward the eye, per unit of optical depth: that of a slab as thick as the cloud is
// along the light's way (lib/cloud_scattering.glsl), less what leaks out across it.
vec3 cloud_leaving(CloudRay ray, CloudPlace place, vec3 p, float to_light, float beyond) {
  float x = clamp(place.x, 0.0, 1.0);
  vec3 light = mix(ray.low_light, ray.high_light,
                   clamp((cloud_altitude(p) - clouds.layer.x) / (clouds.layer.y - clouds.layer.x), 0.0, 1.0));
  float level = clamp(clouds.light_direction.y, 0.0, 1.0);
  float above_light = to_light * clouds.light.x;
  // A layer lies flat; across the light's way its field leaks out of base and top: a parabola that ends 2/3 of a
  // scaled mean free path beyond either. A heap has sides: light comes in by them and goes out by them, and the sky
  // shows on all of them.
  float heap = clamp(place.kind.round_sharply * (1.0 / 0.9), 0.0, 1.0);
  float full = clouds.layer.z * place.kind.extinction * place.kind.thickness * clouds.form.w;
  float scaled = 1.0 - ray.g;
  float middle = 0.5 * scaled * full + kMarshak;
  float kept = (scaled * full * x + kMarshak) * (scaled * full * (1.0 - x) + kMarshak) / (middle * middle);
  // Of a field that hangs on height alone, a share of level^2 of the second derivative lies along the light's way,
  // where cloud_field has it already; the rest across.
  kept = mix(kept, 1.0, level * level);
  float leak = kHeapLeak * heap;
  float facing = mix(max(level, 0.1), kHeapFacing, heap);
  float taken = mix(max(level, 0.1) * kept, (kHeapTakes.x + kHeapTakes.y * level) * (0.60 + 0.74 * x), heap);
  vec3 ambient = cloud_ambient(full * (1.0 - x), full, ray.from_above, ray.from_below, ray.direction.y, ray.g);
  // A heap lets little of the sky's brighter half through to the side that is turned away from the light.
  float along_light = above_light + beyond * clouds.light.x;
  vec3 from_sky = ray.from_above * cloud_ambient(min(above_light, full), full, ray.lit_half, ray.dim_half, ray.cosine, ray.g);
  vec3 around = mix(ray.from_below, from_sky, 0.5 + 0.37 * x);
  // Neighbours whose sides are in the light.
  around += clouds.ambient.y * kOthersReflect * min(1.0 - clouds.weather.w, 1.0) * level * (1.0 - level) / kPhasePi * light;
  // A storm overlooks the tops of the others: its shaded sides see them, and sky by half.
  WHERE_STORMS_STAND {
    float over = smoothstep(800.0, 2500.0, (cloud_altitude(p) - place.base) / clouds.form.w);
    vec3 tops = kTopsReflect * min(1.0 - clouds.weather.w, 1.0) / kPhasePi * light * level;
    around = mix(around, 0.5 * (ray.from_below + tops + from_sky), over);
    // Clefts, where the noise has moved the edge inward, see less of either than turrets.
    around *= 1.0 - kCleftHides * over * clamp(place.inside / max(place.freedom, 0.1), -0.5, 0.5);
  }
  ambient = mix(ambient, around, heap);
  CloudField field = cloud_field(above_light, along_light, facing, ray.g, leak);
  float powder = mix(1.0, cloud_powder(above_light), clouds.ambient.x * clamp(0.5 - 0.5 * ray.cosine, 0.0, 1.0));
  float spread = kFieldGain * (taken / facing) * max(field.mean + kFieldTilt * ray.g * field.tilt * ray.cosine, 0.0);
  float sunlit = powder * (ray.phase * field.once + ray.blurred * field.forward) + spread;
  vec3 leaving = light * max(sunlit, clouds.light.z * 0.25 / kPhasePi) + ambient;
  for (int i = 0; i < int(clouds.flash.w > 0.0); ++i) {
    leaving += kFlashColour * clouds.flash.w * cloud_glow(distance(p, clouds.flash.xyz));
  }
  return leaving * clouds.light.w;
}

// Where in a step of this optical depth, spread evenly, the light comes from that one sees: 1/2 of a thin one, toward
// its begin in a thick one.
float mean_way(float depth) { return depth > 0.05 ? 1.0 / depth - 1.0 / (exp(depth) - 1.0) : 0.5 - depth / 12.0; }

// The low clouds, from `near` to `far`. No sample is shifted at random: what a step holds is a mean, so there are
// no bands to hide, and grain would show in thin layers.
CloudSight march_low(CloudRay ray, float near, float far, int light_steps) {
  CloudSight sight;
  sight.radiance = vec3(0.0);
  sight.transmittance = 1.0;
  float weight = 0.0, weighted = 0.0;
  float pixel = PIXEL_ANGLE;
  float t = near;
  float before = -1.0;      // the signed field at the last sample, and where that was
  float last = near;
  vec3 source = vec3(0.0);  // light that leaves the last place that was lit
  for (int i = 0; i < STEPS; ++i) {
    // Through empty air cell by cell of the weather.
    vec3 p = ray.direction * t;
    for (int skip = 0; skip < SKIPS; ++skip) {
      float clear = LONGEST_SKIP > 0.0 ? min(cloud_clear_way(p, ray.direction), REACH) : 0.0;
      if (clear <= 0.0 || t > far) break;
      before = -1.0;
      t += clear;
      p = ray.direction * t;
    }
    if (t > far) break;
    CloudPlace place = cloud_place(p);
    float base_step = max(FINEST, GROWTH * t) * clouds.march.x;
    float footprint = pixel * t;
    // Detail only takes away: it counts where there is something to take. (Loops that run once or not at
    // all in place of branches, of which a CPU renderer runs both sides.)
    float inside = cloud_body(place, p, footprint);
    float eroded = 0.5 * kCloudErosion * clouds.form.z;
    for (int i = 0; i < int(max(inside, before) > 0.0); ++i) eroded = cloud_erosion(place, p, footprint);
    inside -= eroded;
    // What was skipped is empty: no cloud is spread over it.
    float passed = min(t - last, 4.0 * base_step);
    float depth = clouds.layer.z * place.kind.extinction * cloud_filling(place.x) *
                  cloud_mean_ramp(before, inside, kCloudEdgeWidth) * passed * clouds.light.y;
    float share = sight.transmittance * (1.0 - exp(-depth));
    // Lit only where it shows, at the place that its light comes from; what hardly shows has the light of the place
    // before.
    bool shows = share > kShows || (share > 0.0 && weight == 0.0);
    for (int i = 0; i < int(shows); ++i) {
      float entered = before < 0.0 ? clamp(before / min(before - inside, -1.0e-4), 0.0, 1.0) : 0.0;
      float back = (1.0 - mean_way(depth)) * (1.0 - entered) * passed;
      vec3 q = p - ray.direction * back;
      CloudPlace lit = place;
      lit.x -= back * ray.direction.y / (place.kind.thickness * clouds.form.w);
      vec2 depths = depths_along_light(lit, mix(max(before, 0.0), inside, mean_way(depth)), q, footprint, light_steps);
      source = cloud_leaving(ray, lit, q, depths.x, depths.y);
    }
    sight.radiance += share * source;
    weight += share;
    weighted += share * t;
    sight.transmittance *= exp(-depth);
    if (sight.transmittance < kLeast) break;
    before = inside;
    last = t;
    // In cloud as fine as one can see; outside an edge as far as the field allows.
    t += inside > 0.0 ? base_step * (1.0 + 1.5 * (1.0 - sight.transmittance))
                      : clamp(-inside * clouds.march.z, base_step,
                              max(LONGEST_SKIP * base_step + 37.5 * LONGEST_SKIP, base_step));
  }
  // A ray that has seen all that shows has seen it all.
  float rescale = 1.0 / (1.0 - kLeast);
  sight.radiance /= 1.0 - min(sight.transmittance, kLeast);
  sight.transmittance = max(sight.transmittance - kLeast, 0.0) * rescale;
  sight.distance = weight > 0.0 ? weighted / weight : far > 0.0 ? far : REACH;
  return sight;
}

// The clouds along a ray from the camera, through the air.
CloudSight cloud_sight(vec3 direction, int light_steps) {
  CloudSpan span = cloud_span(vec3(0.0), direction);
  span.far = min(span.far, REACH) * clouds.eye.z;
  CloudSight sight;
  sight.radiance = vec3(0.0);
  sight.transmittance = 1.0;
  sight.distance = REACH;
  CloudRay ray = cloud_ray(direction, min(span.near, REACH));
  sight = march_low(ray, span.near, span.far, light_steps);
  AirLight air = cloud_air(direction, sight.distance, cloud_altitude(direction * sight.distance));
  sight.radiance = sight.radiance * air.transmittance + air.inscattered * (1.0 - sight.transmittance);
  return sight;
}
