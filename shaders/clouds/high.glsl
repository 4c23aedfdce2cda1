// Cirrus and cirrostratus: a layer too thin to march, on a sphere round the earth.

struct HighCloud {
  vec3 radiance;  // of the cloud itself with the air before it
  float share;    // 1 - transmittance
};

// Optical depth over the plan (m): streaks along the wind aloft, drawn out of patches.
float high_cloud_depth(vec2 plan) {
  vec2 along = clouds.high_form.zw;
  vec2 at = clouds.high.xy + plan * clouds.high.z;
  vec4 patches = textureLod(cloud_weather, at, 0.0);
  vec2 drawn = vec2(dot(plan, along) * 0.22, dot(plan, vec2(-along.y, along.x)));
  vec2 curl = textureLod(cloud_curl_noise, clouds.high.xy + 2.2e-5 * plan, 0.0).xy;
  vec2 streak = clouds.high.xy + 1.1e-4 * (drawn + 900.0 * curl);
  float fibres = 0.6 * textureLod(cloud_curl_noise, streak, 0.0).x +
                 0.4 * textureLod(cloud_curl_noise, 2.3 * streak.yx, 0.0).y;
  float field = patches.b * 0.75 + 0.25 * patches.r;
  float cover = smoothstep(clouds.high_form.x - 0.25, clouds.high_form.x + 0.35, field);
  return clouds.high_form.y * cover * clamp(0.45 + 1.1 * fibres, 0.0, 1.5);
}

HighCloud high_cloud(vec3 direction) {
  HighCloud cloud;
  cloud.radiance = vec3(0.0);
  cloud.share = 0.0;
  // A loop that runs once or not at all: no cost where there are none.
  for (int i = 0; i < int(clouds.eye.w); ++i) {
    CloudSpan span = cloud_shell(clouds.eye.x, direction.y, clouds.eye.y, clouds.high.w, clouds.high.w + 500.0);
    if (span.far <= span.near || span.near > 250000.0) break;
    float t = span.near;
    vec3 p = direction * t;
    float slant = clamp((span.far - span.near) / 500.0, 1.0, 8.0);
    float depth = high_cloud_depth(p.xz) * slant;
    cloud.share = 1.0 - exp(-depth);
    vec3 light = clouds.light_direction.xyz;
    vec3 up = normalize(vec3(2.0 * p.x * clouds.eye.y, 1.0, 2.0 * p.z * clouds.eye.y));
    vec3 lit = cloud_light_at(1.0e-3 * clouds.high.w, dot(light, up), clouds.light_source.rgb);
    float cosine = dot(direction, light);
    // Ice scatters forward in a narrow lobe and about evenly otherwise.
    float phase = 0.6 * henyey_greenstein(0.75, cosine) + 0.4 * 0.25 / kPhasePi;
    vec3 source = lit * (phase + 0.12 / kPhasePi) + frame.sky_illuminance.rgb * (0.5 / kPhasePi);
    AirLight air = cloud_air(direction, t, clouds.high.w);
    cloud.radiance = source * clouds.light.w * air.transmittance + air.inscattered;
  }
  return cloud;
}
