// What each pixel of an outline takes from the neighbour across its edge. The search along the edge for the
// ends of its step is FXAA's (Lottes 2011).
#include "lib/colour.glsl"
#include "post/outlines.glsl"
layout(local_size_x = 64) in;
layout(binding = 0) uniform sampler2D shown;

const int kSteps = 8;
const float kStep[kSteps] = float[](1.0, 1.0, 1.0, 1.0, 2.0, 2.0, 4.0, 8.0);  // pixels
const float kThin = 0.6;  // of the neighbour at most, where a thing is thinner than a pixel

vec3 texel(ivec2 at) { return texelFetch(shown, clamp(at, ivec2(0), textureSize(shown, 0) - 1), 0).rgb; }

// Brightness half way between the rows on both sides of an edge.
float between(ivec2 at, ivec2 across) {
  return 0.5 * (brightness(texel(at)) + brightness(texel(at + across)));
}

// How far along an edge its two rows keep their mean brightness, in pixels; how much they have more behind that.
float reach(ivec2 at, ivec2 along, ivec2 across, float mean, float change, out float more) {
  float way = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    way += kStep[i];
    more = between(at + along * int(way), across) - mean;
    if (abs(more) >= change) break;
  }
  return way;
}

// Share of the neighbour across the edge, 0 to .6, and where that is.
float share_of_neighbour(ivec2 at, out ivec2 across) {
  float b[9];
  for (int i = 0; i < 9; ++i) b[i] = brightness(texel(at + ivec2(i % 3 - 1, i / 3 - 1)));
  float least = min(min(min(b[1], b[3]), min(b[5], b[7])), b[4]);
  float most = max(max(max(b[1], b[3]), max(b[5], b[7])), b[4]);

  // Second differences: across a level edge the columns bend.
  float level = 2.0 * abs(b[1] + b[7] - 2.0 * b[4]) + abs(b[0] + b[6] - 2.0 * b[3]) + abs(b[2] + b[8] - 2.0 * b[5]);
  float upright = 2.0 * abs(b[3] + b[5] - 2.0 * b[4]) + abs(b[0] + b[2] - 2.0 * b[1]) + abs(b[6] + b[8] - 2.0 * b[7]);
  bool is_level = level >= upright;
  ivec2 along = is_level ? ivec2(1, 0) : ivec2(0, 1);
  float before = abs((is_level ? b[1] : b[3]) - b[4]);
  float after = abs((is_level ? b[7] : b[5]) - b[4]);
  across = before > after ? -along.yx : along.yx;

  float mean = between(at, across);
  float more_back, more_ahead;
  float change = 0.25 * max(before, after);
  float back = reach(at, -along, across, mean, change, more_back);
  float ahead = reach(at, along, across, mean, change, more_ahead);
  // Only in the row that gives way at the step's nearer end is a part of the other.
  float more = back < ahead ? more_back : more_ahead;
  bool gives_way = (b[4] < mean) != (more < 0.0);
  float by_edge = gives_way ? 0.5 - min(back, ahead) / (back + ahead) : 0.0;

  // What is thinner than a pixel stands out of the mean of all about it.
  float around = (2.0 * (b[1] + b[3] + b[5] + b[7]) + b[0] + b[2] + b[6] + b[8]) / 12.0;
  float stands = smoothstep(0.0, 1.0, abs(around - b[4]) / (most - least));
  return max(by_edge, kThin * stands * stands);
}

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= min(outlines.count, uint(outlines.pixels.length()))) return;
  uint place = outlines.pixels[i].x;
  ivec2 at = ivec2(place & 0xffffu, place >> 16), across;
  float share = share_of_neighbour(at, across);
  vec3 colour = mix(linear_from_srgb(texel(at)), linear_from_srgb(texel(at + across)), share);
  outlines.pixels[i].y = packUnorm4x8(vec4(srgb_from_linear(colour), 1.0));
}
