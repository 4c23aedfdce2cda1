// The clouds marched by brute force: 4096 even steps along the ray, at each the light marched to the end
// of the clouds; no noise, no skipping, no history, no shadow map. The light in the cloud is that of
// march.glsl, so what differs from the march is its sampling alone.
#include "shared/frame.h"
#include "clouds/march.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = 0) uniform image2D seen;   // radiance (cd/m^2), transmittance
layout(rg32f, binding = 1) uniform image2D distance;  // m, weighted; weight. At the end: m
layout(location = 0) uniform ivec2 corner;            // of this part, pixels
layout(location = 1) uniform ivec2 steps;             // of the ray: first and number
layout(location = 2) uniform float smoothed;          // 1: noise is smoothed to a pixel's width, as in the march; 0: not

const int kViewSteps = 4096;
const int kLightSteps = 96;  // each way
const float kNothingLeft = 1.0e-4;

// Optical depth to the end of the clouds, in steps that grow as the square of the distance: fine near
// the place.
float whole_depth(vec3 p, vec3 toward, float footprint) {
  CloudSpan span = cloud_span(p, toward);
  float length_ = min(span.far, REACH);
  float depth = 0.0;
  for (int i = 0; i < kLightSteps; ++i) {
    float a = float(i) / float(kLightSteps), b = float(i + 1) / float(kLightSteps);
    float middle = 0.5 * (a + b);
    depth += cloud_extinction(p + toward * (length_ * middle * middle), footprint) * length_ * (b * b - a * a);
  }
  return depth;
}

void main() {
  ivec2 pixel = corner + ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(seen)))) return;
  vec2 at = (vec2(pixel) + 0.5) / vec2(imageSize(seen));
  vec4 near = frame.relative_from_clip * vec4(2.0 * at - 1.0, 1.0, 1.0);
  vec3 direction = normalize(near.xyz / near.w);
  CloudSpan span = cloud_span(vec3(0.0), direction);
  span.far = min(span.far, REACH) * clouds.eye.z;
  CloudRay ray = cloud_ray(direction, min(span.near, REACH));
  float step_length = max(span.far - span.near, 0.0) / float(kViewSteps);
  // A ray is done in pieces: a CPU renderer ends shaders that loop more than 65535 times.
  bool first = steps.x == 0;
  vec4 before = first ? vec4(0.0, 0.0, 0.0, 1.0) : imageLoad(seen, pixel);
  vec2 before_distance = first ? vec2(0.0) : imageLoad(distance, pixel).rg;
  vec3 radiance = before.rgb;
  float transmittance = before.a;
  float weighted = before_distance.x, weight = before_distance.y;
  for (int i = steps.x; i < steps.x + steps.y; ++i) {
    if (step_length <= 0.0 || transmittance < kNothingLeft) break;
    float t = span.near + (float(i) + 0.5) * step_length;
    vec3 p = direction * t;
    float footprint = smoothed * frame.camera.w * t;
    float extinction = cloud_extinction(p, footprint);
    // Runs once where there is cloud: an `if` would march the light everywhere on a CPU renderer.
    for (int lit = 0; lit < (extinction > 0.0 ? 1 : 0); ++lit) {
      CloudPlace place = cloud_place(p);
      float depth = extinction * step_length * clouds.light.y;
      vec3 light = clouds.light_direction.xyz;
      vec3 source = cloud_leaving(ray, place, p, whole_depth(p, light, footprint),
                                  whole_depth(p, -light, footprint));
      float share = transmittance * (1.0 - exp(-depth));
      radiance += share * source;
      weight += share;
      weighted += share * t;
      transmittance *= exp(-depth);
    }
  }
  if (steps.x + steps.y < kViewSteps) {
    imageStore(seen, pixel, vec4(radiance, transmittance));
    imageStore(distance, pixel, vec4(weighted, weight, 0.0, 0.0));
    return;
  }
  float mean = weight > 0.0 ? weighted / weight : 0.0;
  AirLight air = cloud_air(direction, mean, cloud_altitude(direction * mean));
  radiance = radiance * air.transmittance + air.inscattered * (1.0 - transmittance);
  imageStore(seen, pixel, vec4(radiance, transmittance));
  imageStore(distance, pixel, vec4(mean));
}
