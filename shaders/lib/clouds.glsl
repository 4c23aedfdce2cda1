// The form of clouds: which height a kind of cloud fills, and where its edge is. Compiled as GLSL and as
// double-precision C++. Heights in metres; x is the height within a cloud, 0 at its base, 1 at the top
// that the strongest of its kind reach.

// What the weather says of a column of air.
struct CloudColumn {
  float excess;  // coverage over the threshold: > 0 inside a cloud's plan, some ±1 at most
  float type;    // 0 stratus, 0.5 stratocumulus, 1 cumulus
  float base;    // m over the sea
  float rain;    // 0 … 1
};

// What kind of cloud stands there.
struct CloudKind {
  float thickness;   // m
  float full;        // excess that makes it as tall as that
  float roughness;   // how far the body's noise moves its edge, in units of `full`
  float bottom;      // height x over which the base closes
  float round_from;  // height x from which on it narrows
  float round_sharply;  // 0: narrows with the square of the height from there, 1: with its power 1.5
  float extinction;  // over that of a dense cumulus (stratus .04–.06 /m, cumulus .05–.12 /m measured)
  float sharpness;   // of its edges: by how much the field changes over one `full`
  float given;       // of the field: back for what the edges' noise would take of a thin layer
};

float cloud_blend(float a, float b, float c, float type) {
  float from_middle = 2.0 * type - 1.0;
  return b + (from_middle < 0.0 ? b - a : c - b) * from_middle;
}

CloudKind cloud_kind(float type) {
  CloudKind kind;
  kind.thickness = cloud_blend(320.0, 480.0, 1050.0, type);
  kind.full = cloud_blend(0.32, 0.45, 0.34, type);
  kind.roughness = cloud_blend(0.9, 1.2, 1.35, type);
  kind.bottom = cloud_blend(0.15, 0.45, 0.05, type);
  kind.round_from = cloud_blend(0.0, 0.35, 0.04, type);
  kind.round_sharply = cloud_blend(0.0, 0.3, 0.9, type);
  kind.extinction = cloud_blend(0.9, 0.75, 1.0, type);
  kind.sharpness = cloud_blend(0.4, 0.75, 1.0, type);
  kind.given = cloud_blend(0.15, 0.05, 0.0, type);
  return kind;
}

// How much excess (in units of `full`) it takes to be inside at height x: 0 where the cloud is widest,
// 1 at its top.
float cloud_outline(CloudKind kind, float x) {
  float below = max(1.0 - x / kind.bottom, 0.0);
  float up = max((x - kind.round_from) / (1.0 - kind.round_from), 0.0);
  float narrowing = up * mix(up, sqrt(up), kind.round_sharply);
  float lid = max((x - 0.9) / 0.1, 0.0);
  return below * below + narrowing + 0.5 * lid * lid;
}

// Excess in units of `full`, bounded: a deep cell grows no taller than its kind.
float cloud_strength(CloudKind kind, float excess) {
  float e = excess / kind.full;
  return e > 0.0 ? e * inversesqrt(1.0 + e * e / 1.44) : e;
}

// ---- Storms ----------------------------------------------------------------------------------------
// Where it rains a tower stands in the cloud: its plan is where the rain is more than its outline asks for
// at that height.

const float kStormThickness = 8000.0;
// Strength of the wide noise that sets its turrets apart, in units of `full`, and its periods within the weather's.
const float kStormTurrets = 0.9, kStormTurretPeriods = 6.0;

// Height of the tallest towers over their bases, m; 0: none. Little rain falls from towers of 2.5 km, and
// layers of cloud grow none.
float storm_thickness(float type, float precipitation) {
  return precipitation > 0.0 ? type * mix(2500.0, kStormThickness, smoothstep(0.1, 0.7, precipitation)) : 0.0;
}

// `precipitation`: the rain in the middle of the strongest.
CloudKind storm_kind(float thickness, float precipitation) {
  CloudKind kind;
  kind.thickness = thickness;
  kind.full = 0.6 * precipitation;  // of rain
  kind.roughness = 0.5;
  kind.bottom = 0.012;
  kind.round_from = 0.05;
  kind.round_sharply = 0.0;
  kind.extinction = 1.4;
  kind.sharpness = 3.0;  // rain fades over kilometres
  kind.given = 0.0;
  return kind;
}

// Rain in units of `full`, with the wide noise (0 … 1) at a height where this share of it counts; nothing where
// it does not rain.
float storm_strength(CloudKind kind, float rain, float turrets, float freedom) {
  float strength = rain / kind.full;
  return strength + kStormTurrets * min(4.0 * strength, 1.0) * freedom * (turrets - 0.5);
}

// How much rain (in units of `full`) it takes to be inside at height x: a tower that narrows upward, an anvil
// that spreads from it under the tropopause, with a rim that thins out, and the dome of the strongest over it.
float storm_outline(CloudKind kind, float x) {
  float below = max(1.0 - x / kind.bottom, 0.0);
  float closing = max(x - 0.9, 0.0);
  float tower = 1.0 + 0.25 * clamp((x - kind.round_from) / 0.7, 0.0, 1.0) + 150.0 * closing * closing;
  float under = max(0.89 - x, 0.0) / 0.20, over = closing / 0.04;
  float anvil = 0.15 + under + over * over;
  float spreads = smoothstep(4000.0, 6500.0, kind.thickness);
  return below * below + mix(tower, min(tower, anvil), spreads);
}

// How far the wind has drawn a storm along, m, at a height over the bases where clouds lean by `lean` (m per m): beside
// their even lean its upper half more and more, so that its anvil trails downwind.
const float kAnvilDrawn = 4.0;
float storm_drawn(float over, float lean, float thickness) {
  float up = max(over - 0.5 * thickness, 0.0);
  return lean * (over + kAnvilDrawn * up * up / max(thickness, 1.0));
}
// At most how many times as fast as `lean` that goes there with height.
const float kMostDrawn = 1.0 + 1.2 * kAnvilDrawn;

// Rain that reaches the air beneath: of layers all of it, of heaps what has a tower over it.
float rain_falling(float type, float precipitation, float rain) {
  float under = smoothstep(0.9, 1.3, rain / storm_kind(1.0, max(precipitation, 1.0e-3)).full);
  return rain * mix(1.0, under, smoothstep(0.2, 0.5, type));
}

// How much of a full-grown storm stands where it rains so hard, 0 … 1.
float storm_grown(float type, float precipitation, float rain) {
  float height = storm_thickness(type, precipitation) / kStormThickness;
  CloudKind kind = storm_kind(1.0, max(precipitation, 1.0e-3));
  return height * height * clamp(2.0 * rain / kind.full - 1.0, 0.0, 1.0);
}

// How much of the noise counts at height x: bases are flat.
float cloud_freedom(float x) { return mix(0.30, 1.0, smoothstep(0.0, 0.22, x)); }

// How far it moves the edge of a kind there, in units of `full`: bases that close over some height are no flatter
// than sides.
float cloud_reach(CloudKind kind, float x) { return kind.roughness * cloud_freedom(x + 0.5 * (kind.bottom - 0.05)); }

// Wispy below, where edges are drawn out, and billowy above (Schneider 2015). `noise` 0 … 1 is bright
// within cells.
float cloud_edge(float noise, float x) { return mix(noise, 1.0 - noise, smoothstep(0.02, 0.22, x)); }

// From the signed distance to the edge (in units of `full`) to the share of full density.
const float kCloudEdgeWidth = 0.28;
// Clouds hold more water the higher above their base.
float cloud_filling(float x) { return mix(0.55, 1.0, smoothstep(0.0, 0.35, x)); }
float cloud_density_from(float inside, float x) {
  return clamp(inside / kCloudEdgeWidth, 0.0, 1.0) * cloud_filling(x);
}

// ∫ clamp(f / width, 0, 1) df from 0.
float cloud_ramp_integral(float f, float width) {
  float inside = clamp(f, 0.0, width);
  return 0.5 * inside * inside / width + max(f - width, 0.0);
}

// Mean of clamp(f / width, 0, 1) while f goes evenly from a to b: what a step holds whose ends lie on
// both sides of an edge. Exact for any length of the step where the field is linear.
float cloud_mean_ramp(float a, float b, float width) {
  float across = b - a;
  if (abs(across) < 1.0e-4) return clamp(0.5 * (a + b) / width, 0.0, 1.0);
  return clamp((cloud_ramp_integral(b, width) - cloud_ramp_integral(a, width)) / across, 0.0, 1.0);
}

// ---- The weather -----------------------------------------------------------------------------------

// The normal distribution function, to 1.5e-4 (a logistic curve with a cubic argument). Sums of evenly
// distributed patterns come near to a normal distribution; this makes them even again.
float normal_share(float z) { return 1.0 / (1.0 + exp(-z * (1.5976 + 0.07056 * z * z))); }

// Where a layer's rolls lie in the pattern of cells: in rows, each a fourth as large as there. Whole numbers, so that
// they repeat with it.
vec2 weather_rolls(vec2 at) { return vec2(4.0 * at.x + 3.0 * at.y, 7.0 * at.y - 3.0 * at.x); }

// Coverage 0 … 1, evenly distributed, from evenly distributed patterns: cells, finer cells, fronts and rolls.
// Scattered heaps (type 1) are told by their cells, an overcast of them by its fronts, stratocumulus (0.5) by
// its rolls, stratus (0) by its fronts.
float weather_coverage(vec4 patterns, float cover, float type) {
  vec4 heaps = mix(vec4(0.80, 0.30, 0.34, 0.0), vec4(0.45, 0.28, 0.80, 0.0), cover);
  vec4 rolls = vec4(0.25, 0.25, 0.35, 0.80), even = vec4(0.50, 0.35, 0.45, 0.30);
  vec4 weights = type < 0.5 ? mix(even, rolls, 2.0 * type) : mix(rolls, heaps, 2.0 * type - 1.0);
  float sum = dot(weights, patterns - vec4(0.5));
  return normal_share(sum / sqrt(dot(weights, weights) / 12.0));
}

// What coverage has to exceed for there to be cloud. Its edges take some of a thin cloud: a closed sky has none.
float weather_threshold(float cover) { return 1.0 - cover - 0.25 * smoothstep(0.8, 1.0, cover); }

// Rain falls from layers (type 0) where the fronts stand thickest, from heaps (type 1) in showers: cells of their
// own some kilometres wide, whether or not other clouds stand there.
float weather_rain(float coverage, float fronts, float showers, float cover, float type, float precipitation) {
  float heaps = smoothstep(0.2, 0.5, type);
  float layered = coverage > 1.0 - cover ? 0.6 * coverage + 0.4 * fronts : 0.0;
  float showery = normal_share((0.4 * fronts + 0.6 * showers - 0.5) / sqrt((0.16 + 0.36) / 12.0));
  float from = 1.0 - mix(0.9, 0.3, heaps) * precipitation;
  float full = mix(from + 0.35, 1.0, heaps);
  return precipitation * clamp((mix(layered, showery, heaps) - from) / max(full - from, 1.0e-4), 0.0, 1.0);
}

// ---- Container: a shell round the earth, or a box ------------------------------------------------

struct CloudSpan {
  float near;
  float far;  // not after `near` where there is nothing
};

// The part of a ray with heights between `low` and `high`, from an eye at `height`, in front of the sea
// and of the far side of the shell. Within some hundred kilometres a sphere is a paraboloid:
// height(t) = height + y t + (1 - y²) t² `curvature` with curvature = 1 / diameter. A flat ray beneath
// an exactly level layer is no special case, since the earth is round.
CloudSpan cloud_shell(float height, float y, float curvature, float low, float high) {
  float a = max((1.0 - y * y) * curvature, 1.0e-12);
  // a t² + y t + height - level = 0, by the form that does not cancel.
  float to_low = y * y - 4.0 * a * (height - low);
  float to_high = y * y - 4.0 * a * (height - high);
  float to_sea = y * y - 4.0 * a * height;
  CloudSpan span;
  span.near = 0.0;
  span.far = 0.0;
  float up_root = sqrt(max(to_high, 0.0));
  float leave = y > 0.0 ? 2.0 * (high - height) / (y + up_root) : (up_root - y) / (2.0 * a);
  if (height < low) {
    // From below: in through the lower face; not where the sea comes first.
    float root = sqrt(max(to_low, 0.0));
    span.near = y > 0.0 ? 2.0 * (low - height) / (y + root) : (root - y) / (2.0 * a);
    span.far = y < 0.0 && to_sea >= 0.0 && height >= 0.0 ? span.near : leave;
  } else {
    if (height > high) {
      if (y >= 0.0 || to_high < 0.0) return span;
      span.near = 2.0 * (height - high) / (up_root - y);
    }
    span.far = leave;
    // Down through the lower face, where the ray reaches it.
    if (y < 0.0 && to_low >= 0.0) span.far = 2.0 * (height - low) / (sqrt(to_low) - y);
  }
  return span;
}

// The part of a ray within a box (Kay & Kajiya 1986). A direction along an axis is no special case: its
// zero components are replaced by tiny ones of the same sign.
CloudSpan cloud_box(vec3 origin, vec3 direction, vec3 low, vec3 high) {
  vec3 d = vec3(abs(direction.x) < 1.0e-7 ? (direction.x < 0.0 ? -1.0e-7 : 1.0e-7) : direction.x,
                abs(direction.y) < 1.0e-7 ? (direction.y < 0.0 ? -1.0e-7 : 1.0e-7) : direction.y,
                abs(direction.z) < 1.0e-7 ? (direction.z < 0.0 ? -1.0e-7 : 1.0e-7) : direction.z);
  vec3 a = (low - origin) / d;
  vec3 b = (high - origin) / d;
  vec3 first = min(a, b);
  vec3 last = max(a, b);
  CloudSpan span;
  span.near = max(max(max(first.x, first.y), first.z), 0.0);
  span.far = min(min(last.x, last.y), last.z);
  return span;
}
