// Veils of rain under the cells that the weather map rains from. Needs clouds/shadow.glsl, clouds/air.glsl
// and the includer's uniforms before it.

struct RainVeil {
  vec3 light;  // cd/m^2, with the air before it
  float transmittance;
};

// Extinction of the rain at a place, 1/m. Drops fall into slower air and lag behind their cloud: as the
// square of the height fallen, where the wind falls off evenly.
float rain_extinction_at(vec3 p, float altitude, float footprint) {
  float fallen = clamp(1.0 - altitude / clouds.layer.w, 0.0, 1.0);
  vec2 plan = p.xz + 0.5 * amount.zw * fallen * fallen;
  vec4 weather = textureLod(cloud_weather, cloud_weather_at(plan), 0.0);
  float rain = rain_falling(weather.g, clouds.wind.w, weather.a);
  // Curtains: fine across, long downward.
  vec3 at = 3.0 * (clouds.shape.xyz + vec3(plan.x, 0.15 * altitude, plan.y) * clouds.shape.w);
  float lod = log2(max(3.0 * footprint * clouds.shape.w * kCloudShapeTexels, 1.0));
  float curtain = textureLod(cloud_shape_noise, at, lod).r;
  return rain_extinction(rain_rate(rain, amount.y) * (0.25 + 1.5 * smoothstep(0.2, 0.8, curtain)));
}

RainVeil rain_veil(vec3 direction, CloudSpan span, float jitter) {
  float far = min(span.far, span.near + kRainReach);
  float depth = 0.0, weighted = 0.0;
  for (int i = 0; i < steps.y; ++i) {
    float u = (float(i) + jitter) / float(steps.y);
    float along = mix(span.near, far, u * sqrt(u));
    float length = (far - span.near) * 1.5 * sqrt(u) / float(steps.y);
    vec3 p = direction * along;
    float here = length * rain_extinction_at(p, cloud_altitude(p), max(frame.camera.w * 4.0 * along, 60.0));
    // Where its light comes from, in the mean.
    float seen = exp(-depth) * (1.0 - exp(-here));
    weighted += seen * along;
    depth += here;
  }
  RainVeil veil;
  veil.transmittance = exp(-depth);
  float opaque = 1.0 - veil.transmittance;
  float along = opaque > 1.0e-4 ? weighted / opaque : span.near;
  // It stands in the shadow of its cloud, in what the sky beside it sends: a quarter of all round it.
  vec3 p = direction * along;
  bool by_day = frame.sun_illuminance.g >= frame.moon_illuminance.g;
  vec3 lux = by_day ? frame.sun_illuminance.rgb : frame.moon_illuminance.rgb;
  float scaled = 0.15 * max(cloud_shadow_depth(p), 40.0);
  float through = (5.0 - exp(-scaled)) / (4.0 + 3.0 * scaled);
  vec3 above = through * (frame.sky_illuminance.rgb + lux * max(clouds.light_direction.y, 0.0)) / kPhasePi;
  vec3 beside = frame.sky_illuminance.rgb / kPhasePi;
  vec3 light = 0.5 * above + 0.25 * beside;
  // Lightning stands among it or behind it: an even share of what comes.
  light += 0.25 / kPhasePi * frame.flash_illuminance.rgb;
  AirLight air = cloud_air(direction, along, cloud_altitude(p));
  veil.light = opaque * (light * air.transmittance + air.inscattered);
  return veil;
}
