// Irradiance as spherical harmonics.
#include "lib/phase.glsl"
#include "lib/probe.glsl"
#include "lib/scattering.glsl"
#include "shared/probe.h"
#include "sky/probe_cell.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) writeonly buffer Coefficients { vec4 coefficients[kProbeHarmonics]; };
layout(std430, binding = 1) readonly buffer Cells { Cell cells[]; };
layout(location = 3) uniform int count;
layout(location = 5) uniform int plain;  // 1: sky_irradiance() of sky.glsl instead

shared vec3 sums[kProbeHarmonics][64];
shared float angles[64];

void main() {
  uint me = gl_LocalInvocationID.x;
  vec3 sum[kProbeHarmonics];
  for (int k = 0; k < kProbeHarmonics; ++k) sum[k] = vec3(0.0);
  float angle = 0.0;
  for (int i = int(me); i < count; i += 64) {
    vec3 light = cells[i].light.rgb;
    ProbeBasis b = probe_basis(cells[i].middle.xyz);
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
    angle += cells[i].middle.w;
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
