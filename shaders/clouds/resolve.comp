// The clouds of the whole picture from the few pixels that were marched now and all that were before:
// reprojected by the camera's way and the wind, and held to what the neighbourhood shows now.
#include "shared/frame.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D seen;
layout(binding = 1) uniform sampler2D distance_seen;
layout(binding = 2) uniform sampler2D least;
layout(binding = 3) uniform sampler2D most;
layout(binding = 4) uniform sampler2D history;  // linear
layout(binding = 5) uniform sampler2D seen_linear;
layout(rgba16f, binding = 0) uniform writeonly image2D result;
layout(location = 0) uniform ivec2 cell;
layout(location = 1) uniform ivec2 chosen;
layout(location = 2) uniform vec3 moved;  // add to a place to have it as it lay before the last frame
layout(location = 3) uniform mat4 clip_before;
layout(location = 7) uniform float fresh;  // weight of a new value
layout(location = 8) uniform int first_row;  // below it there is only sea
layout(location = 9) uniform int first_row_before;  // … and was in the last frame
layout(location = 10) uniform float scale;  // of the picture's pixels over the screen's

// An old value outside of what the neighbourhood holds, drawn toward its middle until it lies within: light and
// transmittance together, since each alone would leave a cloud without its light.
vec4 clipped(vec4 old, vec4 low, vec4 high) {
  const float kSlack = 1.5;
  vec4 middle = 0.5 * (low + high);
  vec4 off = abs(old - middle) / max(0.5 * kSlack * (high - low), vec4(1.0e-3));
  return middle + (old - middle) / max(max(max(off.x, off.y), max(off.z, off.w)), 1.0);
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, first_row);
  ivec2 size = imageSize(result);
  if (any(greaterThanEqual(pixel, size))) return;
  ivec2 cells = textureSize(seen, 0);
  ivec2 texel = min(pixel / cell, cells - 1);
  vec2 at = vec2(pixel) + 0.5;
  vec4 near = frame.relative_from_clip * vec4(2.0 * scale * at * frame.viewport.zw - 1.0, 1.0, 1.0);
  vec3 direction = normalize(near.xyz / near.w);
  vec3 before = direction * texelFetch(distance_seen, texel, 0).r + moved;
  vec4 clip = clip_before * vec4(before, 1.0);
  vec2 at_before = (0.5 + 0.5 * clip.xy / max(clip.w, 1.0e-6)) * frame.viewport.xy / scale;
  bool known = clip.w > 0.0 && all(greaterThan(at_before, vec2(0.0, float(first_row_before) + 0.5))) &&
               all(lessThan(at_before, vec2(size)));
  // Less than half a pixel is no reason to blur: the pixel's own turn comes soon. (Loops that run once or
  // not at all in place of branches, of which a CPU renderer runs both sides.)
  vec2 way = at_before - at;
  bool still = dot(way, way) < 0.2;
  vec4 old = vec4(0.0);
  for (int i = 0; i < int(known && still); ++i) old = texelFetch(history, pixel, 0);
  for (int i = 0; i < int(known && !still); ++i) old = textureLod(history, at_before / vec2(size), 0.0);
  // Where this round's samples lie, between texels.
  for (int i = 0; i < int(!known); ++i) {
    old = textureLod(seen_linear, (at - vec2(chosen) - 0.5 + 0.5 * vec2(cell)) / vec2(cell * cells), 0.0);
  }
  vec4 value = clipped(old, texelFetch(least, texel, 0), texelFetch(most, texel, 0));
  bool own = all(equal(pixel - texel * cell, chosen));
  value = own ? mix(value, texelFetch(seen, texel, 0), known ? fresh : 1.0) : value;
  imageStore(result, pixel, value);
}
