// The march of the main source (J. Raja Huertas 2023, appendix A), said again for the benchmark: what the
// clouds cost without anything that this project adds. Full size, even steps from the container's entry to
// its end, at each cloudy step as many even light steps to the container's end; its density (A.4, A.5) on
// our noise; Beer, powder and two Henyey-Greenstein lobes of equal weight (A.3, A.6, A.8).
#include "shared/frame.h"
#include "sky/sky.glsl"
#include "clouds/density.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = 0) uniform writeonly image2D seen;  // radiance (cd/m^2), transmittance
layout(location = 0) uniform ivec2 corner;                    // of this part, pixels
layout(location = 1) uniform vec2 steps;                      // length (m); number of light steps

const float kSide = 40000.0;      // m: of its box, round the camera
const float kBottom = 700.0;      // m
const float kTop = 2400.0;
const float kExtinction = 0.04;   // 1/m: its density is without a unit
const float kThreshold = -2.6;
const float kDetail = 0.6;
const float kEdgeFade = 3000.0;   // m
const float kSunAbsorption = 0.5;
const float kDarkness = 0.15;

float remap_to_unit(float v, float from, float to) { return clamp((v - from) / (to - from), 0.0, 1.0); }

float source_density(vec3 p) {
  float altitude = clouds.eye.x + p.y;
  float edge = min(min(kSide * 0.5 - abs(p.x), kSide * 0.5 - abs(p.z)), kEdgeFade) / kEdgeFade;
  float gradient = textureLod(cloud_weather, cloud_weather_at(p.xz), 0.0).r;
  float least = mix(0.1, 0.5, gradient);
  float most = mix(least, 0.9, gradient);
  float height = (altitude - kBottom) / (kTop - kBottom);
  float by_height = remap_to_unit(height, 0.0, least) * remap_to_unit(height, 1.0, most) * max(edge, 0.0);
  float body = textureLod(cloud_shape_noise, clouds.shape.xyz + p * clouds.shape.w, 0.0).r * by_height;
  float volume = body + 0.1 * kThreshold;
  float density = 0.0;
  for (int i = 0; i < (volume > 0.0 ? 1 : 0); ++i) {
    float noise = textureLod(cloud_detail_noise, clouds.detail.xyz + p * clouds.detail.w, 0.0).r;
    float erode = (1.0 - body) * (1.0 - body) * (1.0 - body);
    density = max(volume - (1.0 - noise) * erode * kDetail, 0.0);
  }
  return density;
}

CloudSpan source_box(vec3 origin, vec3 direction) {
  return cloud_box(origin, direction, vec3(-0.5 * kSide, kBottom - clouds.eye.x, -0.5 * kSide),
                   vec3(0.5 * kSide, kTop - clouds.eye.x, 0.5 * kSide));
}

void main() {
  ivec2 pixel = corner + ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(seen)))) return;
  vec2 at = (vec2(pixel) + 0.5) / vec2(imageSize(seen));
  vec4 near = frame.relative_from_clip * vec4(2.0 * at - 1.0, 1.0, 1.0);
  vec3 direction = normalize(near.xyz / near.w);
  CloudSpan span = source_box(vec3(0.0), direction);
  vec3 toward = clouds.light_direction.xyz;
  float cosine = dot(direction, toward);
  float phase = 0.5 * henyey_greenstein(0.7, cosine) + 0.5 * henyey_greenstein(-0.3, cosine) + 0.12;
  float energy = 0.0;
  float transmittance = 1.0;
  for (float t = span.near; t < span.far; t += steps.x) {
    vec3 p = direction * t;
    float density = source_density(p);
    for (int lit = 0; lit < (density > 0.0 ? 1 : 0); ++lit) {
      float inside = source_box(p, toward).far;
      float light_step = inside / steps.y;
      float total = 0.0;
      for (int i = 0; i < int(steps.y); ++i)
        total += source_density(p + toward * ((float(i) + 0.5) * light_step)) * light_step;
      float through = kDarkness + (1.0 - kDarkness) * exp(-total * kExtinction * kSunAbsorption);
      float depth = density * steps.x * kExtinction;
      energy += depth * transmittance * through * phase * (1.0 - exp(-2.0 * density * 8.0));
      transmittance *= exp(-depth);
    }
    if (transmittance < 0.01) break;
  }
  vec3 light = energy * (frame.sun_illuminance.rgb + frame.moon_illuminance.rgb);
  imageStore(seen, pixel, vec4(light, transmittance));
}
