// Light at a depth and along a way through the water. Needs shared/frame.h and sky/sky.glsl before it.
#include "lib/water.glsl"
#include "lib/underwater.glsl"
#include "shared/bindings.h"
#include "shared/underwater.h"
#include "clouds/shadow.glsl"

layout(binding = 7) uniform sampler2DArray caustic_map;

const float kSkyPassing = 0.934;  // of light from an even sky through level water (Preisendorfer 1976)
const float kFarAway = 2000.0;    // m: no light comes from farther in any water

// Illuminance of the brighter of sun and moon above the water, lux.
vec3 bright_light() { return water.bright.rgb * cloud_shadow(vec3(0.0)); }

// What goes down just below the surface, lux on a level plane.
struct Daylight {
  vec3 direct;   // of sun or moon
  vec3 diffuse;  // of the sky
};
Daylight daylight() {
  Daylight day;
  day.direct = bright_light() * (water.light.w * water.light.y);
  day.diffuse = probe_irradiance(vec3(0.0, 1.0, 0.0)) * kSkyPassing;
  return day;
}

// What of a beam is still one at this depth: rgb, over all of the light that came down.
vec3 unscattered(float depth) {
  return exp(min(water.diffuse.rgb - water.beam.rgb, vec3(0.0)) *
             (max(depth, 0.0) / water.light.y));
}

// Light gathered by the waves over that under a level sea, at a place relative to the camera.
// `size`: m over which the mean is taken.
float caustic(vec3 relative, float depth, float size) {
  vec2 at = relative.xz + water.light.xz * (depth / water.light.y) - water.caustics.xy;
  vec2 unit = at / water.caustics.z;
  float layer = log(max(depth, 1.0e-3) / kCausticFirst) / log(kCausticRatio);
  float inside = 1.0 - smoothstep(0.36, 0.47, max(abs(unit.x), abs(unit.y)));
  inside *= clamp(depth / kCausticFirst, 0.0, 1.0);
  float l = clamp(layer, 0.0, float(kCausticLayers - 1));
  float lower = min(floor(l), float(kCausticLayers - 2));
  float level = log2(max(size * water.caustics.w / water.caustics.z, 1.0));
  float pattern = mix(textureLod(caustic_map, vec3(unit + 0.5, lower), level).r,
                      textureLod(caustic_map, vec3(unit + 0.5, lower + 1.0), level).r, l - lower);
  return 1.0 + inside * water.bright.w * (pattern - 1.0);
}

// Light scattered toward the eye from `depth` on along `direction`, over `s` m.
struct PathLight {
  vec3 from_sky;
  vec3 from_light;  // of sun or moon
};
PathLight path_light(Daylight day, float depth, vec3 direction, float s) {
  // No water above the sea.
  float way = min(s, direction.y > 0.0 ? (max(depth, 0.0) + 1.0) / direction.y : kFarAway);
  vec3 k = water.beam.rgb - water.diffuse.rgb * direction.y;
  vec3 lost = exp(-water.diffuse.rgb * max(depth, 0.0)) * path_integral(k, way);
  // From all round, many times scattered: straight down and without end it comes to `glow`. Forward
  // of that, once.
  vec3 round = water.glow.rgb * (water.beam.rgb + water.diffuse.rgb) * lost;
  vec3 once = water.once.rgb * lost;
  // Deep down nothing tells where a beam came from.
  vec3 still = sqrt(unscattered(depth));
  vec3 even = max(round + once * (scattering_shape(kSkyG, direction.y) - 1.0), vec3(0.0));
  vec3 beamed = once * (scattering_shape(kSunG, dot(direction, water.light.xyz)) - 1.0);
  PathLight light;
  light.from_sky = even * (day.diffuse + day.direct * (vec3(1.0) - still));
  light.from_light = max(round + beamed, vec3(0.0)) * day.direct * still;
  return light;
}
