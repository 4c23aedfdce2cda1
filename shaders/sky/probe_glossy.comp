// A glossy level of the probe, whose lobe is narrower than the cells of probe_rough.comp: sampled in the
// order of a sunflower's seeds, for every texel alike. Each sample reads the mip whose texels are as large
// as the share of the lobe that it stands for (Krivanek & Colbert, "Real-time shading with filtered
// importance sampling", EGSR 2008).
#include "sky/probe_map.glsl"

layout(local_size_x = 16, local_size_y = 4) in;
layout(rgba16f, binding = 0) uniform writeonly image2D map;
layout(location = 2) uniform float alpha;
layout(location = 3) uniform int samples;
layout(location = 5) uniform float dip;  // sine of the horizon's angle below the level

const float kGoldenAngle = 2.39996323;
const float kPi = 3.14159265;

void main() {
  ProbeTexel t = this_texel();
  if (!t.inside) return;
  vec3 n = probe_direction(t.units, t.below ? -1.0 : 1.0);
  vec3 right = normalize(cross(abs(n.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0), n));
  vec3 ahead = cross(n, right);
  // Light from above the horizon and from below it apart, each the mean of its own samples. How much of
  // the lobe lies above is known exactly for each ring, and no chance of where samples fall decides
  // about the jump between sky and sea.
  float steep = sqrt(max(1.0 - n.y * n.y, 1.0e-12));
  vec3 up_sum = vec3(0.0), down_sum = vec3(0.0);
  float up_weight = 0.0, down_weight = 0.0, above = 0.0;
  float a2 = alpha * alpha, size = mip_side();
  for (int i = 0; i < samples; ++i) {
    // The facet's normal h (Walter et al. 2007, eq. 35); the direction is n mirrored in it.
    float u = (float(i) + 0.5) / float(samples);
    float c2 = (1.0 - u) / (1.0 + (a2 - 1.0) * u);
    float weight = 2.0 * c2 - 1.0;  // n.l
    if (weight <= 0.0) break;
    float across = 2.0 * sqrt(c2 * (1.0 - c2));
    float turn = kGoldenAngle * float(i);
    vec3 l = weight * n + across * (cos(turn) * right + sin(turn) * ahead);
    // It stands for a solid angle of 4 / (samples D(h)). A quarter of that: reading is bilinear.
    vec2 units = probe_units(l);
    float width = 1.0 + (a2 - 1.0) * c2;
    float angle = 4.0 * kPi * width * width / (a2 * float(samples));
    float level = 0.5 * log2(0.25 * angle * size * size / (probe_solid_angle(units) + 0.02));
    bool up = l.y >= -dip;
    vec3 light = weight * read_mip(units, !up, level);
    up_sum += up ? light : vec3(0.0);
    up_weight += up ? weight : 0.0;
    down_sum += up ? vec3(0.0) : light;
    down_weight += up ? 0.0 : weight;
    above += weight * acos(clamp(-(weight * n.y + dip) / (across * steep), -1.0, 1.0));
  }
  above /= kPi * (up_weight + down_weight);
  vec3 up_mean = up_sum / max(up_weight, 1.0e-6), down_mean = down_sum / max(down_weight, 1.0e-6);
  above = up_weight <= 0.0 ? 0.0 : down_weight <= 0.0 ? 1.0 : above;
  imageStore(map, t.place, vec4(mix(down_mean, up_mean, above), 1.0));
}
