// Histogram of the picture's luminance: one pixel of every 4 × 4, since an eye does not adapt to less.
#include "lib/colour.glsl"
#include "post/exposure.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform sampler2D hdr;
layout(std430, binding = 0) buffer State { ExposureState state; };
layout(location = 0) uniform float exposure;  // of the picture

shared uint bins[kBins];

void main() {
  uint me = gl_LocalInvocationIndex;
  if (me < uint(kBins)) bins[me] = 0u;
  barrier();
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) * 4 + 2;
  if (all(lessThan(pixel, textureSize(hdr, 0)))) {
    float luminance = colour_luminance(texelFetch(hdr, pixel, 0).rgb) / exposure;
    // Also false for what is not a number.
    if (luminance > 0.0 && luminance < 1.0e12) {
      float bin = (log2(luminance) - kLowestBin) * kBinsPerStop;
      atomicAdd(bins[int(clamp(bin, 0.0, float(kBins - 1)))], 1u);
    }
  }
  barrier();
  if (me < uint(kBins) && bins[me] > 0u) atomicAdd(state.histogram[me], bins[me]);
}
