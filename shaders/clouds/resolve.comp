// The clouds of the whole picture from the few pixels that were marched now and all that were before:
// reprojected by the camera's way and the wind, and held to what the neighbourhood shows now. One call for each
// cell of CELL_X × CELL_Y pixels, since most of what its pixels need is the same.
#include "shared/frame.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D seen;  // one texel a cell
layout(binding = 1) uniform sampler2D distance_seen;
layout(binding = 2) uniform sampler2D history;
layout(binding = 3) uniform sampler2D entered;  // what was marched of all that the last frame did not show; linear
layout(rgba16f, binding = 0) uniform writeonly image2D result;
layout(location = 1) uniform ivec2 chosen;
layout(location = 2) uniform vec3 moved;  // add to a place to have it as it lay before the last frame
layout(location = 3) uniform mat4 clip_before;
layout(location = 7) uniform float fresh;  // weight of a new value
layout(location = 8) uniform int first_row;  // of cells; below it there is only sea
layout(location = 9) uniform int first_row_before;  // of pixels, in the last frame
layout(location = 10) uniform ivec4 known;  // pixels that the last frame showed: from, to
layout(location = 11) uniform float sea_below;  // a direction's sine under which the sea hides all clouds
layout(location = 12) uniform ivec2 entered_cell;  // of `entered`, as of `seen`
layout(location = 13) uniform ivec2 entered_chosen;

const ivec2 kCell = ivec2(CELL_X, CELL_Y);

// Where the picture held this place (relative to the eye) before, in pixels.
vec2 place_before(vec3 place) {
  vec4 clip = clip_before * vec4(place, 1.0);
  return (0.5 + 0.5 * clip.xy / max(clip.w, 1.0e-3)) * frame.viewport.xy;
}

// Weights of four texels for a place so far (0 to 1) between the second and the third: the spline of Catmull & Rom
// 1974, which keeps what a line between two would blur when it is drawn anew in every frame.
vec4 spline(float x) {
  return vec4(((-0.5 * x + 1.0) * x - 0.5) * x, (1.5 * x - 2.5) * x * x + 1.0,
              ((-1.5 * x + 2.0) * x + 0.5) * x, (0.5 * x - 0.5) * x * x);
}

// A column of the old picture as high as a cell, moved by less than a pixel: `at` is a texel before its first.
vec4[CELL_Y] column_before(ivec2 at, vec4 along) {
  vec4 texels[CELL_Y + 3];
  ivec2 last = textureSize(history, 0) - 1;
  for (int j = 0; j < CELL_Y + 3; ++j)
    texels[j] = texelFetch(history, clamp(at + ivec2(0, j), ivec2(0, first_row_before), last), 0);
  vec4 column[CELL_Y];
  for (int j = 0; j < CELL_Y; ++j) {
    column[j] = texels[j] * along.x + texels[j + 1] * along.y + texels[j + 2] * along.z + texels[j + 3] * along.w;
  }
  return column;
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
  const float kSlack = 1.5, kSame = 1.0e-3;
  const vec4 kMost = vec4(30000.0, 30000.0, 30000.0, 1.0);
  vec4 middle = 0.5 * (low + high);
  ivec2 size = imageSize(result);
  // A cell moves as one: over its few pixels the way back differs by hundredths of a pixel.
  vec2 centre = (vec2(texel) + 0.5) * vec2(kCell);
  vec4 through = frame.relative_from_clip * vec4(2.0 * centre * frame.viewport.zw - 1.0, 1.0, 1.0);
  vec3 place = normalize(through.xyz / through.w) * texelFetch(distance_seen, texel, 0).r;
  vec2 before = place_before(place + moved);
  vec2 way = before - centre;
  const float kRounds = 2.0 * float(CELL_X * CELL_Y);  // frames; what was said of a pixel by then is forgotten
  // Less than half a pixel until its turn comes again is no reason to blur.
  way = kRounds * length(way) < 1.0 ? vec2(0.0) : way;
  // An old value outside of what its neighbourhood shows now, and half as much again, is drawn toward its middle until
  // it lies within: light and transmittance together, since each alone would leave a cloud without its light. But
  // only as far as its place is in doubt: by a share of the way that hangs on its distance. What the camera has
  // turned to is where it was, and may be smaller than a cell.
  const float kDoubt = 0.25;
  float doubt = min(kDoubt * kRounds * length(before - place_before(place)), 1.0);
  vec4 per_reach = doubt / max(0.5 * kSlack * (high - low), vec4(kSame));
  vec2 whole = floor(way);
  vec4 across = spline(way.x - whole.x), along = spline(way.y - whole.y);
  ivec2 corner = texel * kCell;
  ivec2 from = corner + ivec2(whole) - 1;
  // A ray's direction goes evenly over the picture; what lies behind the sea is no cloud's neighbour.
  vec2 up_per_pixel = vec2(frame.relative_from_clip[0].y, frame.relative_from_clip[1].y) * 2.0 * frame.viewport.zw;
  float over_sea = through.y - sea_below * length(through.xyz);
  vec4 first[CELL_Y] = column_before(from, along);
  vec4 second[CELL_Y] = column_before(from + ivec2(1, 0), along);
  vec4 third[CELL_Y] = column_before(from + ivec2(2, 0), along);
  for (int i = 0; i < CELL_X; ++i) {
    vec4 fourth[CELL_Y] = column_before(from + ivec2(i + 3, 0), along);
    for (int j = 0; j < CELL_Y; ++j) {
      vec4 old = first[j] * across.x + second[j] * across.y + third[j] * across.z + fourth[j] * across.w;
      vec4 off = abs(old - middle) * per_reach;
      vec4 value = middle + (old - middle) / max(max(max(off.x, off.y), max(off.z, off.w)), 1.0);
      bool hidden = over_sea + dot(up_per_pixel, vec2(i, j) - 0.5 * vec2(kCell - 1)) < 0.0;
      value = hidden ? vec4(0.0, 0.0, 0.0, 1.0) : clamp(value, vec4(0.0), kMost);
      ivec2 within = ivec2(i, j);
      imageStore(result, corner + within, within == chosen ? mix(value, now, fresh) : value);
    }
    first = second;
    second = third;
    third = fourth;
  }
  // What was not seen before.
  bool cell_known = all(greaterThanEqual(corner, known.xy)) && all(lessThanEqual(corner + kCell, known.zw));
  vec2 per_cell = 1.0 / vec2(textureSize(entered, 0));
  float entered_row = float(first_row * CELL_Y / entered_cell.y);
  for (int i = 0; i < (cell_known ? 0 : CELL_X * CELL_Y); ++i) {
    ivec2 pixel = corner + ivec2(i % CELL_X, i / CELL_X);
    vec2 at = vec2(pixel - entered_chosen) / vec2(entered_cell) + 0.5;
    vec4 value = textureLod(entered, vec2(at.x, max(at.y, entered_row + 0.5)) * per_cell, 0.0);
    bool before_all = all(greaterThanEqual(pixel, known.xy)) && all(lessThan(pixel, known.zw));
    if (!before_all) imageStore(result, pixel, pixel - corner == chosen ? now : value);
  }
}
