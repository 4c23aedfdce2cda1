// What the probe should hold, by brute force: for each query the sum over some of many samples of what is
// seen itself, not of any map of it; for tests and the benchmark. Samples are Hammersley's points.
#include "shared/frame.h"
#include "sky/sky.glsl"
#include "sky/probe_source.glsl"
#include "sky/probe.glsl"

layout(local_size_x = 32) in;
struct Query {
  vec4 direction;  // w: roughness; below 0: irradiance instead
};
layout(std430, binding = 0) readonly buffer Queries { Query queries[]; };
struct Answer {
  vec4 reference;  // rgb: sum over the samples of this batch; w: of their weights
  vec4 probe;
};
layout(std430, binding = 1) writeonly buffer Answers { Answer answers[]; };
layout(location = 0) uniform int samples;
layout(location = 1) uniform int count;
layout(location = 2) uniform ivec2 batch;  // first sample, one after the last

void main() {
  uint me = gl_GlobalInvocationID.x;
  if (me >= uint(count)) return;
  vec3 n = queries[me].direction.xyz;
  float roughness = queries[me].direction.w;
  bool lit = roughness < 0.0;
  float a2 = roughness * roughness * roughness * roughness;
  vec3 helper = abs(n.x) < 0.7 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 0.0, 1.0);
  vec3 s = normalize(cross(n, helper));
  vec3 t = cross(n, s);
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  for (int i = batch.x; i < batch.y; ++i) {
    float u = (float(i) + 0.5) / float(samples);
    float turn = 6.28318531 * float(bitfieldReverse(uint(i))) / 4294967296.0;
    // The tangent of the facet's angle for GGX; the direction's own sine for irradiance.
    float tangent2 = lit ? u / (1.0 - u) : a2 * u / (1.0 - u);
    float cosine = inversesqrt(1.0 + tangent2), sine = sqrt(max(1.0 - cosine * cosine, 0.0));
    vec3 h = cosine * n + sine * (cos(turn) * s + sin(turn) * t);
    vec3 d = lit ? h : reflect(-n, h);
    float weight = lit ? 1.0 : max(dot(d, n), 0.0);
    sum += weight * probe_source(d);
    weights += weight;
  }
  vec3 scale = frame.sky_illuminance.rgb;
  answers[me].reference = vec4(sum * scale * (lit ? 3.14159265 : 1.0), weights);
  answers[me].probe = vec4(lit ? probe_irradiance(n) : probe_radiance(n, roughness), 0.0);
}
