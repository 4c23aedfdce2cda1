// What the probe sees: sky and clouds above the horizon, the mean sea below it. Needs shared/frame.h
// and sky/sky.glsl before it.
#include "lib/cloud_map.glsl"
#include "lib/water.glsl"

// Clouds round the boat, where there are any: rgb their radiance in cd/m^2, a the share of the sky
// behind them that shows. See lib/cloud_map.glsl.
layout(binding = OFFING_UNIT_CLOUD_MAP) uniform sampler2D cloud_map;
layout(location = 4) uniform int clouds;  // 0 or 1

vec3 sky_and_clouds(vec3 d) {
  vec3 radiance = sky_radiance(d);
  for (int i = 0; i < clouds; ++i) {
    vec4 seen = textureLod(cloud_map, cloud_map_units(d), 0.0);
    radiance = radiance * seen.a + seen.rgb;
  }
  return radiance;
}

// What a sea of this slope variance reflects of light from (or toward) a direction at this sine over the
// level, and the mean slope toward it of the facets that do.
struct SeaMirror {
  float slope, reflectance;
};
SeaMirror sea_mirror(float sine, float variance) {
  float across = sqrt(max(1.0 - sine * sine, 0.0));
  SeaMirror m;
  m.slope = sqrt(variance) * visible_facets(sine, sqrt(variance) * across).slope;
  float cosine = (sine + across * m.slope) * inversesqrt(1.0 + m.slope * m.slope);
  m.reflectance = fresnel_water(clamp(cosine, 0.02, 1.0));
  return m;
}

// Radiance from a direction in cd/m^2. Below the horizon lies a sea of the wind's mean slopes (Cox & Munk 1954)
// without its single waves: the sky that facets mirror, light from the water below, and what is reflected of
// sun and moon. Their glitter is spread over all directions: a rough mirror or a hull sees as much light, and
// a small map can hold it.
vec3 sky_clouds_and_sea(vec3 d) {
  const vec3 kBody = vec3(0.0013, 0.0057, 0.0095);  // share of light sent back from below, per sr
  bool below = d.y <= -sky.observer.y;
  float variance = 0.5 * (0.003 + 0.00512 * frame.wind.w);  // along each axis
  SeaMirror seen = sea_mirror(max(-d.y, 0.0), variance);
  vec2 toward = normalize(d.xz + vec2(1.0e-6, 0.0));
  vec3 mirrored = reflect(d, normalize(vec3(-toward.x * seen.slope, 1.0, -toward.y * seen.slope)));
  mirrored = normalize(vec3(mirrored.x, abs(mirrored.y) + 1.0e-3, mirrored.z));
  vec3 radiance = sky_and_clouds(below ? mirrored : d);
  // A loop, as a CPU renderer runs both sides of an if.
  for (int sea = 0; sea < int(below); ++sea) {
    vec3 fallen = frame.sky_illuminance.rgb;
    radiance *= seen.reflectance;
    for (int i = 0; i < 2; ++i) {
      float sine = max(i == 0 ? frame.sun_direction.y : frame.moon_direction.y, 0.0);
      vec3 lux = sine * (i == 0 ? frame.sun_illuminance.rgb : frame.moon_illuminance.rgb);
      fallen += lux;
      radiance += lux * (sea_mirror(sine, variance).reflectance / kWaterPi);
    }
    radiance += (1.0 - seen.reflectance) * kBody * fallen;
  }
  return radiance;
}

// The same over the sky's level illuminance, as the probe holds it.
vec3 probe_source(vec3 d) { return sky_clouds_and_sea(d) / max(frame.sky_illuminance.rgb, vec3(1.0e-9)); }
