// Where there is cloud, and how dense. Of the C++ side Clouds::bind() and CloudIds::read_by().
#include "lib/clouds.glsl"
#include "shared/bindings.h"
#include "shared/clouds.h"

layout(binding = OFFING_UNIT_CLOUD_SHAPE) uniform sampler3D cloud_shape_noise;
layout(binding = OFFING_UNIT_CLOUD_DETAIL) uniform sampler3D cloud_detail_noise;
layout(binding = OFFING_UNIT_CLOUD_CURL) uniform sampler2D cloud_curl_noise;
layout(binding = OFFING_UNIT_CLOUD_WEATHER) uniform sampler2D cloud_weather;
layout(binding = OFFING_UNIT_CLOUD_MOST) uniform sampler2D cloud_most;

const float kCloudShapeTexels = 128.0;
const float kCloudDetailTexels = 32.0;

// Height over the sea of a place relative to the camera, over the curved earth.
float cloud_altitude(vec3 p) {
  return clouds.eye.x + p.y + dot(p.xz, p.xz) * clouds.eye.y;
}

// Before what only storms need. A loop that runs once or not at all, since a CPU renderer runs both sides of a
// branch; but it counts the rounds as well, so a reference, which has many, says CLOUDS_BRANCH.
#if defined(CLOUDS_WITHOUT_STORMS)
#define WHERE_STORMS_STAND if (false)
#elif defined(CLOUDS_BRANCH)
#define WHERE_STORMS_STAND if (clouds.eye.w > 0.0)
#else
#define WHERE_STORMS_STAND for (int once = 0; once < int(clouds.eye.w > 0.0); ++once)
#endif

// Where a place was before the wind drew the tops along.
vec2 cloud_unsheared(vec3 p, float altitude) {
  float over = altitude - clouds.layer.w;
  float drawn = clouds.wind.z * over;
  WHERE_STORMS_STAND drawn = storm_drawn(over, clouds.wind.z, clouds.eye.w * clouds.form.w);
  return p.xz - clouds.wind.xy * drawn;
}

vec2 cloud_weather_at(vec2 plan) { return clouds.weather.xy + plan * clouds.weather.z; }

CloudColumn cloud_column_from(vec4 weather, vec2 plan) {
  CloudColumn column;
  vec2 inside = vec2(clouds.box.z) - abs(plan - clouds.box.xy);
  float fade = clamp(1.0 - min(inside.x, inside.y) * clouds.box.w, 0.0, 2.0);
  column.excess = weather.r - clouds.weather.w - fade;
  column.type = weather.g;
  column.rain = weather.a;
  column.base = mix(clouds.layer.x, 2.0 * clouds.layer.w - clouds.layer.x, weather.b);
  return column;
}

CloudColumn cloud_column(vec2 plan) {
  return cloud_column_from(textureLod(cloud_weather, cloud_weather_at(plan), 0.0), plan);
}

// A place in its column: all that needs no noise.
struct CloudPlace {
  CloudKind kind;
  float base;     // m over the sea
  float x;        // height within the cloud, 0 … 1
  float inside;   // > 0 inside an edge without noise, in units of the kind's `full`
  float freedom;  // how far the body's noise moves that edge
  float smoothed;  // how little is eaten off its edges, 0 … 1
  vec2 plan;
};

// Where a storm reaches further than the cloud that it stands in, it takes over.
CloudPlace cloud_place_in_storm(CloudPlace place, float rain, float altitude) {
  CloudKind kind = storm_kind(clouds.eye.w, clouds.wind.w);
  float x = (altitude - place.base) / (kind.thickness * clouds.form.w);
  // A whole number of periods within the weather's, so that it does not jump where that repeats.
  vec2 at = kStormTurretPeriods * cloud_weather_at(place.plan);
  float up = kStormTurretPeriods * clouds.weather.z * altitude;
  float turrets = textureLod(cloud_shape_noise, vec3(at.x, up, at.y), 1.0).r;
  float free = clouds.form.y * cloud_freedom(5.0 * x);
  float strength = storm_strength(kind, rain, turrets, free);
  float inside = kind.sharpness * (strength - storm_outline(kind, x)) - clouds.form.x;
  // Ice above: smooth and thin, a veil where no tower feeds it.
  float ice = smoothstep(0.70, 0.82, x);
  float fed = smoothstep(0.2, 1.4, strength);
  kind.extinction *= mix(1.0, 0.002 + 0.3 * fed * fed, ice);
  float share = smoothstep(-0.25, 0.25, inside - place.inside);
  place.kind.thickness = mix(place.kind.thickness, kind.thickness, share);
  place.kind.roughness = mix(place.kind.roughness, kind.roughness, share);
  place.kind.extinction = mix(place.kind.extinction, kind.extinction, share);
  place.x = mix(place.x, x, share);
  place.freedom = mix(place.freedom, kind.sharpness * kind.roughness * free, share);
  place.inside = max(place.inside, inside);
  place.smoothed = 0.6 * share * ice;
  return place;
}

CloudPlace cloud_place_in(CloudPlace place, float excess, float rain, float altitude) {
  place.x = (altitude - place.base) / (place.kind.thickness * clouds.form.w);
  float strength = cloud_strength(place.kind, excess);
  float edge = place.kind.given - clouds.form.x;
  place.inside = place.kind.sharpness * (strength - cloud_outline(place.kind, place.x)) + edge;
  place.freedom = place.kind.sharpness * clouds.form.y * cloud_reach(place.kind, place.x);
  place.smoothed = 0.0;
  WHERE_STORMS_STAND place = cloud_place_in_storm(place, rain, altitude);
  return place;
}

CloudPlace cloud_place(vec3 p) {
  CloudPlace place;
  float altitude = cloud_altitude(p);
  place.plan = cloud_unsheared(p, altitude);
  CloudColumn column = cloud_column(place.plan);
  place.kind = cloud_kind(column.type);
  place.base = column.base;
  return cloud_place_in(place, column.excess, column.rain, altitude);
}

// The same for a place not far from another: of the same type, with a base as high.
CloudPlace cloud_place_beside(CloudPlace place, vec3 p) {
  float altitude = cloud_altitude(p);
  place.plan = cloud_unsheared(p, altitude);
  vec4 weather = textureLod(cloud_weather, cloud_weather_at(place.plan), 0.0);
  // What a storm has mixed in is taken out again.
  WHERE_STORMS_STAND place.kind = cloud_kind(weather.g);
  return cloud_place_in(place, weather.r - clouds.weather.w, weather.a, altitude);
}

// The most that noise can add: where this is not positive there is no cloud.
float cloud_most_inside(CloudPlace place) { return place.inside + 0.5 * place.freedom; }

// Where a way (cells per m) from within a cell reaches whichever of its walls comes first, m.
float cloud_cell_end(vec2 at, vec2 way) {
  vec2 ahead = 0.5 + sign(way) * (fract(at) - 0.5);  // 0 at the wall behind, 1 at the one before
  vec2 ends = (1.0 - ahead) / max(abs(way), vec2(1.0e-9));
  return min(ends.x, ends.y);
}

// How far a ray can go on from a place without meeting any cloud, because the coarse cell of the weather
// that it crosses holds none, or none so high on a way up: to the cell's end, or 0.
float cloud_clear_way(vec3 p, vec3 direction) {
  const float kCells = 128.0;  // WeatherMap::kCells
  float altitude = cloud_altitude(p);
  vec2 at = cloud_weather_at(cloud_unsheared(p, altitude)) * kCells;
  float most = textureLod(cloud_most, at * (1.0 / kCells), 0.0).r;
  float top = mix(2.0 * clouds.layer.w - clouds.layer.x, clouds.layer.y, most);
  // A storm's height draws it along by something between the even lean and the most of it.
  vec2 drawn = clouds.wind.xy * (clouds.wind.z * direction.y);
  float scale = clouds.weather.z * kCells;
  float ends = cloud_cell_end(at, (direction.xz - drawn) * scale);
  WHERE_STORMS_STAND ends = min(ends, cloud_cell_end(at, (direction.xz - kMostDrawn * drawn) * scale));
  bool clear = most <= 0.0 || (direction.y >= 0.0 && altitude > top);
  return clear ? ends + 1.0 : 0.0;
}

vec3 cloud_shape_at(CloudPlace place, vec3 p) {
  return clouds.shape.xyz + vec3(place.plan.x, p.y, place.plan.y) * clouds.shape.w;
}

// `inside` with the body's noise; footprint in m: what is finer is smoothed away.
float cloud_body(CloudPlace place, vec3 p, float footprint) {
  float lod = log2(max(footprint * clouds.shape.w * kCloudShapeTexels, 1.0));
  float noise = textureLod(cloud_shape_noise, cloud_shape_at(place, p), lod).r;
  return place.inside + place.freedom * (noise - 0.5);
}

// What the edges' noise takes away from `inside`: nothing in the middle of a cell of noise.
const float kCloudErosion = 0.30;
// The same in the mean, for ways along the light: of a heap's edges, averaged over such ways from within it.
const float kCloudMeanErosion = 0.47 * kCloudErosion;
float cloud_erosion(CloudPlace place, vec3 p, float footprint) {
  vec2 plan = place.plan;
#ifndef CLOUDS_WITHOUT_CURL
  vec2 curl = textureLod(cloud_curl_noise, clouds.curl.xy + place.plan * clouds.curl.z, 0.0).xy;
  plan += curl * (clouds.curl.w * (1.0 - clamp(4.0 * place.x, 0.0, 0.8)));
#endif
  float lod = log2(max(footprint * clouds.detail.w * kCloudDetailTexels, 1.0));
  float noise = textureLod(cloud_detail_noise,
                           clouds.detail.xyz + vec3(plan.x, p.y, plan.y) * clouds.detail.w, lod).r;
  return kCloudErosion * clouds.form.z * (1.0 - place.smoothed) * cloud_edge(noise, place.x * place.kind.sharpness * place.kind.sharpness);
}

float cloud_extinction_from(CloudPlace place, float inside) {
  return clouds.layer.z * place.kind.extinction * cloud_density_from(inside, place.x);
}

// Share of full density without the edges' noise, 0 … 1.
float cloud_density_cheap(vec3 p) {
  CloudPlace place = cloud_place(p);
  return cloud_density_from(cloud_body(place, p, 0.0), place.x);
}

// Extinction (1/m) at a place relative to the camera, with all its detail down to `footprint` (m).
float cloud_extinction(vec3 p, float footprint) {
  CloudPlace place = cloud_place(p);
  if (cloud_most_inside(place) <= 0.0) return 0.0;
  float inside = cloud_body(place, p, footprint);
  return cloud_extinction_from(place, inside - cloud_erosion(place, p, footprint));
}

// The part of a ray from `origin` (relative to the camera) that may hold low clouds.
CloudSpan cloud_span(vec3 origin, vec3 direction) {
  // Over the round earth "up" leans with the distance from the camera.
  vec3 up = normalize(vec3(2.0 * origin.x * clouds.eye.y, 1.0, 2.0 * origin.z * clouds.eye.y));
  CloudSpan span = cloud_shell(cloud_altitude(origin), dot(direction, up), clouds.eye.y,
                               clouds.layer.x, clouds.layer.y);
  vec3 low = vec3(clouds.box.x - clouds.box.z, -1.0e7, clouds.box.y - clouds.box.z);
  vec3 high = vec3(clouds.box.x + clouds.box.z, 1.0e7, clouds.box.y + clouds.box.z);
  CloudSpan box = cloud_box(origin, direction, low, high);
  span.near = max(span.near, box.near);
  span.far = min(span.far, box.far);
  return span;
}
