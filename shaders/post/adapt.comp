// From the histogram to the exposure, and a part of the way there.
#include "post/exposure.glsl"

layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer State { ExposureState state; };
layout(location = 0) uniform float exposure;  // of the picture
layout(location = 1) uniform float expected;  // log2 of the luminance that this exposure is right for
layout(location = 2) uniform vec4 limits;     // stops: least, most, preference; w: share followed
layout(location = 3) uniform vec2 shares;     // of the way in this frame, to the brighter, to the darker
layout(location = 4) uniform vec2 kept;       // part of the histogram that counts, from … to

void main() {
  float total = 0.0;
  for (int i = 0; i < kBins; ++i) total += float(state.histogram[i]);
  // The mean of what is neither among the darkest nor among the brightest.
  float from = kept.x * total, to = kept.y * total, below = 0.0, sum = 0.0, count = 0.0;
  for (int i = 0; i < kBins; ++i) {
    float here = float(state.histogram[i]);
    float counted = max(min(below + here, to) - max(below, from), 0.0);
    sum += counted * ((float(i) + 0.5) / kBinsPerStop + kLowestBin);
    count += counted;
    below += here;
    state.histogram[i] = 0u;
  }
  float metered = count > 0.0 ? sum / count : expected;
  float stops = log2(exposure) + clamp(limits.w * (expected - metered), limits.x, limits.y) + limits.z;
  // A smaller exposure is adaptation to more light, which is the faster one.
  float share = stops < state.stops ? shares.x : shares.y;
  state.stops = state.adapted == 0u ? stops : mix(state.stops, stops, share);
  state.adapted = 1u;
  state.metered = metered;
  state.factor = exp2(state.stops) / exposure;
}
