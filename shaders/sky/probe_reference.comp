// What the probe should hold, by brute force: for each query the sum over some of many samples of what is
// seen itself, not of any map of it; for tests and the benchmark. Samples are Hammersley's points, half of them about the query's
// lobe and half about the sun, whose glow a wide lobe would meet with few.
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

// What a surface mirrors, or is lit by.
struct Lobe {
  vec3 n;
  float alpha;
  bool lit;
};

vec3 about(vec3 axis, float cosine, float turn) {
  vec3 helper = abs(axis.x) < 0.7 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 0.0, 1.0);
  vec3 s = normalize(cross(axis, helper));
  return cosine * axis + sqrt(max(1.0 - cosine * cosine, 0.0)) * (cos(turn) * s + sin(turn) * cross(axis, s));
}

vec3 lobe_direction(Lobe lobe, float u, float turn) {
  // The tangent of the facet's angle for GGX; the direction's own for irradiance.
  float tangent2 = u / (1.0 - u) * (lobe.lit ? 1.0 : lobe.alpha * lobe.alpha);
  vec3 h = about(lobe.n, inversesqrt(1.0 + tangent2), turn);
  return lobe.lit ? h : reflect(-lobe.n, h);
}

// Of directions, by solid angle.
float lobe_density(Lobe lobe, vec3 d) {
  float cosine = dot(d, lobe.n);
  if (lobe.lit) return max(cosine, 0.0) / 3.14159265;
  // GGX's D over 4, with the facet half way: its squared sine is (1 - cosine) / 2.
  float a2 = lobe.alpha * lobe.alpha, s2 = 0.5 * length(d - lobe.n) * length(d - lobe.n) * 0.5;
  float base = s2 + a2 * (1.0 - s2);
  return a2 / (12.5663706 * base * base);
}

// The glow about the sun, wherever the lobe is: Henyey and Greenstein's with g = 0.8.
const float kGlow = 0.8;
float glow_cosine(float u) {
  float q = (1.0 - kGlow * kGlow) / (1.0 - kGlow + 2.0 * kGlow * u);
  return clamp((1.0 + kGlow * kGlow - q * q) / (2.0 * kGlow), -1.0, 1.0);
}
float glow_density(float cosine) {
  float base = 1.0 + kGlow * kGlow - 2.0 * kGlow * cosine;
  return (1.0 - kGlow * kGlow) / (12.5663706 * base * sqrt(base));
}

void main() {
  uint me = gl_GlobalInvocationID.x;
  if (me >= uint(count)) return;
  vec3 n = queries[me].direction.xyz;
  float roughness = queries[me].direction.w;
  bool lit = roughness < 0.0;
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  Lobe lobe = Lobe(n, max(roughness * roughness, 1.0e-4), lit);
  vec3 glow = normalize(vec3(frame.sun_direction.x, max(frame.sun_direction.y, 0.0), frame.sun_direction.z));
  for (int i = batch.x; i < batch.y; ++i) {
    float u = (float(i) + 0.5) / float(samples);
    float turn = 6.28318531 * float(bitfieldReverse(uint(i))) / 4294967296.0;
    // The first half go by the lobe, the second by the glow: each counts as one of their mixture (Veach 1997).
    bool second = 2.0 * u > 1.0 && samples > 1;
    u = samples > 1 ? fract(2.0 * u) : u;
    vec3 d = second ? about(glow, glow_cosine(u), turn) : lobe_direction(lobe, u, turn);
    float density = lobe_density(lobe, d);
    float weight = lit ? 1.0 : max(dot(d, n), 0.0);
    weight *= samples > 1 ? 2.0 * density / (density + glow_density(dot(d, glow))) : 1.0;
    sum += weight * probe_source(d);
    weights += weight;
  }
  vec3 scale = frame.sky_illuminance.rgb;
  answers[me].reference = vec4(sum * scale * (lit ? 3.14159265 : 1.0), weights);
  answers[me].probe = vec4(lit ? probe_irradiance(n) : probe_radiance(n, roughness), 0.0);
}
