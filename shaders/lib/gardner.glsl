// Clouds as a texture on a plane and on ellipsoids: G. Gardner, "Visual Simulation of Clouds", SIGGRAPH
// 1985, after the summary of Lopez et al. (its equation numbers are used here). Compiled as GLSL and as
// double-precision C++.
const float kGardnerPi = 3.14159265358979323846;
const int kGardnerTerms = 7;

// The texture function (3)-(7): a product of two short sums of sines, each frequency twice the one
// before at .707 of its amplitude, each phase shifted by the other coordinate (and by the height, which
// is 0 on a plane). `p` in wavelengths of the first term, so the pattern repeats after 2. 0 to 1;
// `contrast` is T0 (1 or more keeps both sums positive). `terms` (4 to 7) of the series are summed, less
// those shorter than two samples `footprint` apart (in the same wavelengths), faded out as in Gardner's
// own antialiasing.
float gardner_texture(vec3 p, int terms, float contrast, float footprint) {
  float frequency = 2.0 * kGardnerPi;
  float amplitude = 1.0;
  float sum_x = 0.0;
  float sum_y = 0.0;
  float most = 0.0;
  for (int i = 0; i < terms; ++i) {
    float waves = footprint * frequency / (2.0 * kGardnerPi);  // per sample
    float keep = clamp(2.0 - 4.0 * waves, 0.0, 1.0);
    float height_phase = kGardnerPi * sin(0.5 * frequency * p.z);
    float phase_x = 0.5 * kGardnerPi * sin(0.5 * frequency * p.y) + height_phase;
    float phase_y = 0.5 * kGardnerPi * sin(0.5 * frequency * p.x) + height_phase;
    sum_x += amplitude * (keep * sin(frequency * p.x + phase_x) + contrast);
    sum_y += amplitude * (keep * sin(frequency * p.y + phase_y) + contrast);
    most += amplitude * (1.0 + contrast);
    frequency *= 2.0;
    amplitude *= 0.707;
  }
  return sum_x * sum_y / (most * most);
}

// (9): how much shows through, from the texture's value: all below `threshold`, nothing above
// `threshold` + `range`.
float gardner_translucency(float value, float threshold, float range) {
  return clamp(1.0 - (value - threshold) / range, 0.0, 1.0);
}

// (11): the same on an ellipsoid, more translucent toward its limb. `limb` is 1 in the middle of the
// ellipsoid's picture and 0 at its outline.
float gardner_limb_translucency(float value, float limb, float threshold, float threshold_limb,
                                float range) {
  float moved = threshold + (threshold_limb - threshold) * (1.0 - limb);
  return clamp(1.0 - (value - moved) / range, 0.0, 1.0);
}

// (8): ambient share `a`, texture share `t`, specular share `s`.
float gardner_shade(float diffuse, float specular, float value, float a, float t, float s) {
  return (1.0 - a) * ((1.0 - t) * ((1.0 - s) * diffuse + s * specular) + t * value) + a;
}

// A ray and the unit sphere round the origin: (2) after scaling. `limb` is the normalised limb function
// of (10): 1 for a ray through the centre, 0 at the outline, negative beside it.
struct GardnerHit {
  float limb;
  float along;  // where the ray enters, in units of `direction`
};
GardnerHit gardner_hit(vec3 origin, vec3 direction) {
  float a = dot(direction, direction);
  float b = dot(origin, direction);
  float middle = -b / a;
  vec3 nearest = origin + middle * direction;
  GardnerHit hit;
  hit.limb = 1.0 - dot(nearest, nearest);
  hit.along = middle - sqrt(max(hit.limb, 0.0) / a);
  return hit;
}
