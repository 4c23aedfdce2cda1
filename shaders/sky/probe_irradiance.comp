// Irradiance as spherical harmonics.
#include "lib/phase.glsl"
#include "lib/probe.glsl"
#include "lib/scattering.glsl"
#include "shared/probe.h"

layout(local_size_x = 64) in;
layout(std430, binding = 0) writeonly buffer Coefficients { vec4 coefficients[kProbeHarmonics]; };
layout(binding = 0) uniform sampler2D places;  // of nodes: see engine/sky/probe_plan.h
layout(binding = 1) uniform sampler2D seen;
layout(location = 0) uniform ivec4 region;  // of those that are summed: first row, width, height
layout(location = 5) uniform int plain;  // 1: sky_irradiance() of sky.glsl instead

shared vec3 sums[kProbeHarmonics][64];
shared float angles[64];

void main() {
  uint me = gl_LocalInvocationID.x;
  vec3 sum[kProbeHarmonics];
  for (int k = 0; k < kProbeHarmonics; ++k) sum[k] = vec3(0.0);
  float angle = 0.0;
  for (int i = int(me); i < region.y * region.z; i += 64) {
    ivec2 at = ivec2(i % region.y, region.x + i / region.y);
    vec4 place = texelFetch(places, at, 0);
    vec3 light = place.w * texelFetch(seen, at, 0).rgb;
    ProbeBasis b = probe_basis(place.xyz);
    sum[0] += b.constant * light;
    sum[1] += b.linear.x * light;
    sum[2] += b.linear.y * light;
    sum[3] += b.linear.z * light;
    sum[4] += b.product.x * light;
    sum[5] += b.product.y * light;
    sum[6] += b.product.z * light;
    sum[7] += b.zonal * light;
    sum[8] += b.sectoral * light;
    sum[9] += b.ring * light;
    angle += place.w;
  }
  for (int k = 0; k < kProbeHarmonics; ++k) sums[k][me] = sum[k];
  angles[me] = angle;
  barrier();
  if (me < uint(kProbeHarmonics)) {
    vec3 total = vec3(0.0);
    float whole = 0.0;
    for (int i = 0; i < 64; ++i) {
      total += sums[me][i];
      whole += angles[i];
    }
    float cosine = me == 0u ? kProbeCosine0 : me < 4u ? kProbeCosine1 : me < 9u ? kProbeCosine2 : kProbeCosine4;
    vec3 measured = total * (cosine * 4.0 * 3.14159265 / whole);
    // An even sky over a dim sea: a constant and a part that goes with the normal's height.
    ProbeBasis up = probe_basis(vec3(0.0, 1.0, 0.0));
    float even = me == 0u   ? 0.5 * (1.0 + kSeaAlbedo) / up.constant
                 : me == 2u ? 0.5 * (1.0 - kSeaAlbedo) / up.linear.y
                            : 0.0;
    coefficients[me] = vec4(plain > 0 ? vec3(even) : measured, 0.0);
  }
}
