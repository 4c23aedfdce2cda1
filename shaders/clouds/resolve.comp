// The clouds of the whole picture from the few pixels that were marched now and all that were before:
// reprojected by the camera's way and the wind, and held to what the neighbourhood shows now. One call for each
// cell, since most of what its pixels need is the same.
#include "shared/frame.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D seen;  // one texel a cell
layout(binding = 1) uniform sampler2D distance_seen;
layout(binding = 2) uniform sampler2D history;  // linear
layout(binding = 3) uniform sampler2D seen_linear;
layout(rgba16f, binding = 0) uniform writeonly image2D result;
layout(location = 0) uniform ivec2 cell;
layout(location = 1) uniform ivec2 chosen;
layout(location = 2) uniform vec3 moved;  // add to a place to have it as it lay before the last frame
layout(location = 3) uniform mat4 clip_before;
layout(location = 7) uniform float fresh;  // weight of a new value
layout(location = 8) uniform int first_row;  // of cells; below it there is only sea
layout(location = 9) uniform int first_row_before;  // of pixels, in the last frame
layout(location = 10) uniform int has_history;  // 0: after a cut

// Where the picture held this before, in pixels; far to the left where that is not known.
vec2 place_before(vec2 at, float distance) {
  vec4 near = frame.relative_from_clip * vec4(2.0 * at * frame.viewport.zw - 1.0, 1.0, 1.0);
  vec3 before = normalize(near.xyz / near.w) * distance + moved;
  vec4 clip = clip_before * vec4(before, 1.0);
  return clip.w > 0.0 ? (0.5 + 0.5 * clip.xy / clip.w) * frame.viewport.xy : vec2(-1.0e5);
}

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, first_row);
  ivec2 cells = textureSize(seen, 0);
  if (any(greaterThanEqual(texel, cells))) return;
  vec4 now = texelFetch(seen, texel, 0);
  vec4 low = now, high = now;
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i) {
      vec4 value = texelFetch(seen, clamp(texel + ivec2(i, j), ivec2(0, first_row), cells - 1), 0);
      low = min(low, value);
      high = max(high, value);
    }
  }
  // An old value outside of this, and half as much again, is drawn toward its middle until it lies within: light
  // and transmittance together, since each alone would leave a cloud without its light. But what lies where it lay
  // may be smaller than a cell, and its own turn comes soon.
  const float kSlack = 1.5, kSame = 1.0e-3;
  vec4 middle = 0.5 * (low + high);
  vec4 per_reach = 1.0 / max(0.5 * kSlack * (high - low), vec4(kSame));
  vec2 size = vec2(imageSize(result));
  float distance = texelFetch(distance_seen, texel, 0).r;
  // Over a cell the way back is as good as linear.
  vec2 first = vec2(texel * cell) + 0.5, whole = vec2(cell);
  vec2 first_before = place_before(first, distance);
  vec2 last_before = place_before(first + whole, distance);
  vec2 right_before = place_before(first + vec2(whole.x, 0.0), distance);
  bool seen_before = min(min(first_before.x, last_before.x), right_before.x) > -1.0e4;
  mat2 before_per_pixel = mat2((right_before - first_before) / whole.x, (last_before - right_before) / whole.y);
  ivec2 within = ivec2(0);
  for (int i = 0; i < cell.x * cell.y; ++i) {
    ivec2 pixel = texel * cell + within;
    vec2 at = vec2(pixel) + 0.5;
    vec2 at_before = first_before + before_per_pixel * vec2(within);
    bool known = has_history > 0 && seen_before && all(greaterThan(at_before, vec2(0.0, float(first_row_before) + 0.49))) &&
                 all(lessThan(at_before, size));
    // Less than half a pixel until its turn comes again is no reason to blur.
    vec2 way = 2.0 * float(cell.x * cell.y) * (at_before - at);
    float far = dot(way, way);
    vec4 old = textureLod(history, (far < 1.0 ? at : at_before) / size, 0.0);
    // What is new lies between this round's samples.
    vec2 between = (at - vec2(chosen) - 0.5) / vec2(cell) + 0.5;
    between.y = max(between.y, float(first_row) + 0.5);
    if (!known) old = textureLod(seen_linear, between / vec2(cells), 0.0);
    vec4 off = abs(old - middle) * per_reach * min(far, 1.0);
    vec4 value = middle + (old - middle) / max(max(max(off.x, off.y), max(off.z, off.w)), 1.0);
    imageStore(result, pixel, within == chosen ? mix(value, now, known ? fresh : 1.0) : value);
    ++within.x;
    within = within.x < cell.x ? within : ivec2(0, within.y + 1);
  }
}
