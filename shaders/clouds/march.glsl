// Light and transmittance of the clouds along one ray. Needs shared/frame.h before it.
#include "sky/sky.glsl"
#include "lib/cloud_light.glsl"
#include "clouds/density.glsl"
#include "clouds/shadow.glsl"
#include "clouds/air.glsl"
#include "clouds/high.glsl"

// The includer's quality: STEPS, LIGHT_STEPS, FINEST (m), GROWTH (m per m of distance), REACH (m).
const float kLeast = 0.008;  // transmittance at which a ray has seen all that shows

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
  CloudOctaves phases;
  float cosine;       // to the light
  float similarity;   // 1 - g
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
  float g = clouds.phase.x * (1.0 - clouds.phase.z) - clouds.phase.y * clouds.phase.z;
  ray.similarity = 1.0 - clamp(g * clouds.phase.w, 0.0, 0.95);
  vec2 lobes = clouds.phase.xy;
  vec2 squared = lobes * lobes;
  vec3 phases = vec3(dual_phase(lobes.x, lobes.y, clouds.phase.z, ray.cosine),
                     dual_phase(squared.x, squared.y, clouds.phase.z, ray.cosine),
                     dual_phase(squared.x * squared.x, squared.y * squared.y, clouds.phase.z, ray.cosine));
  phases = mix(vec3(0.25 / kPhasePi), phases, clouds.phase.w);
  ray.phases = CloudOctaves(phases.x, phases.y, phases.z);
  return ray;
}

// Optical depth from a place toward the light: some steps that double, and the shadow map beyond.
float depth_to_light(vec3 p, float footprint, int steps) {
  vec3 toward = clouds.light_direction.xyz;
  float step_length = 30.0 * clouds.form.w;
  float along = 0.0;
  float depth = 0.0;
  for (int i = 0; i < steps; ++i) {
    vec3 q = p + toward * (along + 0.6 * step_length);
    CloudPlace place = cloud_place(q);
    float inside = cloud_body(place, q, max(footprint, 0.5 * step_length)) - 0.5 * kCloudErosion * clouds.form.z;
    depth += step_length * cloud_extinction_from(place, inside);
    along += step_length;
    step_length *= 2.0;
  }
  for (int i = 0; i < min(steps, 1); ++i) depth += cloud_shadow_depth(p + toward * along);
  return depth;
}

// Light leaving a place toward the eye, per unit of optical depth.
vec3 cloud_source(CloudRay ray, CloudPlace place, vec3 p, float altitude, float extinction, float to_light) {
  float x = clamp(place.x, 0.0, 1.0);
  vec3 light = mix(ray.low_light, ray.high_light,
                   clamp((altitude - clouds.layer.x) / (clouds.layer.y - clouds.layer.x), 0.0, 1.0));
  float depth = to_light * clouds.light.x;
  float scaled = ray.similarity * depth;
  // What lies beyond, away from the light, lets light out: bases are lit through, not black.
  float full = clouds.layer.z * place.kind.extinction * ray.similarity;
  float deep = clamp(place.inside, 0.05, 1.0);
  float beyond = full * x * place.kind.thickness * clouds.form.w * deep;
  float mu = mix(clamp(clouds.light_direction.y, 0.12, 1.0), 1.0, place.kind.roughness);
  CloudDiffuse diffuse = cloud_diffuse(scaled * mu, scaled * mu + beyond, mu);
  float powder = mix(1.0, 1.0 - exp(-2.0 * depth), clouds.ambient.x * clamp(0.5 - 0.5 * ray.cosine, 0.0, 1.0));
  float beam = cloud_beam(ray.phases, depth, scaled) * powder;
  float scattered = max(diffuse.mean + (1.0 - ray.similarity) * diffuse.flow * ray.cosine, 0.0);
  vec3 sunlit = light * max(beam + scattered, clouds.light.z * 0.25 / kPhasePi);
  // From sky and sea, less what the cloud itself keeps off (1/(1 + 3/4 t): Eddington's slab).
  float above = full * (1.0 - x) * place.kind.thickness * clouds.form.w * deep;
  vec3 ambient = 0.5 * (ray.from_above / (1.0 + 0.75 * above) + ray.from_below / (1.0 + 0.75 * beyond));
  // Near an edge the sky shows from the side as well.
  ambient += 0.22 * ray.from_above * (1.0 - clamp(place.inside, 0.0, 1.0));
  return (sunlit + ambient) * clouds.light.w;
}

// The low clouds, from `near` to `far`. `jitter` 0 … 1 shifts the samples.
CloudSight march_low(CloudRay ray, float near, float far, float jitter, int light_steps) {
  CloudSight sight;
  sight.radiance = vec3(0.0);
  sight.transmittance = 1.0;
  float weight = 0.0, weighted = 0.0;
  float pixel = frame.camera.w;
  float t = near;
  float before = -1.0;      // the signed field at the last sample
  float step_length = max(FINEST, GROWTH * t) * clouds.march.x;
  t += jitter * step_length;
  for (int i = 0; i < STEPS; ++i) {
    CloudPlace place;
    vec3 p;
    float most = 0.0;
    // Through empty air on the weather alone.
    for (int skip = 0; skip < SKIPS; ++skip) {
      p = ray.direction * t;
      place = cloud_place(p);
      most = cloud_most_inside(place);
      if (most > 0.0 || t > far) break;
      before = most;
      step_length = max(FINEST, GROWTH * t) * clouds.march.x;
      step_length = clamp(-most * 260.0 * clouds.form.w, step_length, 4.0 * step_length + 150.0);
      t += step_length;
    }
    if (t > far) break;
    float footprint = pixel * t;
    float inside = cloud_body(place, p, footprint);
    // Detail where the edge is near; it only takes away.
    float erosion = cloud_erosion(place, p, footprint);
    inside -= erosion;
    float extinction = clouds.layer.z * place.kind.extinction *
                       mix(0.55, 1.0, smoothstep(0.0, 0.35, place.x)) *
                       cloud_mean_ramp(before, inside, kCloudEdgeWidth);
    before = inside;
    float depth = extinction * step_length * clouds.light.y;
    float altitude = cloud_altitude(p);
    float to_light = depth_to_light(p, footprint, depth > 1.0e-5 ? light_steps : 0);
    vec3 source = cloud_source(ray, place, p, altitude, extinction, to_light);
    float share = sight.transmittance * cloud_step_light(depth);
    sight.radiance += share * source;
    weight += share;
    weighted += share * t;
    sight.transmittance *= exp(-depth);
    if (sight.transmittance < kLeast) break;
    // In cloud as fine as one can see; outside an edge as far as the field allows.
    float base_step = max(FINEST, GROWTH * t) * clouds.march.x;
    step_length = inside > 0.0 ? base_step * (1.0 + 1.5 * (1.0 - sight.transmittance))
                               : clamp(-inside * 200.0 * clouds.form.w, base_step, 4.0 * base_step);
    t += step_length;
  }
  // A ray that has seen all that shows has seen it all.
  float rescale = 1.0 / (1.0 - kLeast);
  sight.transmittance = max(sight.transmittance - kLeast, 0.0) * rescale;
  sight.distance = weight > 0.0 ? weighted / weight : far;
  return sight;
}

// All clouds along a ray from the camera.
CloudSight cloud_sight(vec3 direction, float jitter, int light_steps) {
  CloudSpan span = cloud_span(vec3(0.0), direction);
  span.far = min(span.far, REACH) * clouds.eye.z;
  CloudSight sight;
  sight.radiance = vec3(0.0);
  sight.transmittance = 1.0;
  sight.distance = REACH;
  CloudRay ray = cloud_ray(direction, min(span.near, REACH));
  sight = march_low(ray, span.near, span.far, jitter, light_steps);
  AirLight air = cloud_air(direction, sight.distance, cloud_altitude(direction * sight.distance));
  sight.radiance = sight.radiance * air.transmittance + air.inscattered * (1.0 - sight.transmittance);
  // The high clouds behind them.
  HighCloud high = high_cloud(direction);
  vec3 seen = high.radiance * high.share;
  sight.radiance += sight.transmittance * seen;
  sight.transmittance *= 1.0 - high.share;
  return sight;
}
