// How a rough water surface looks: slopes, Fresnel reflection, the facets an eye can see, breaking.
// Compiled as GLSL and as double-precision C++. Slopes are dh/dx, dh/dz; a facet's normal is
// (-sx, 1, -sz) normalised.

const float kWaterIndex = 1.34;        // of refraction, sea water in green light
const float kWaterPi = 3.14159265358979323846;

// det d(x)/d(q) of the displaced surface x = q + D(q): 1 at rest, below 0 where it folds. Taken of
// the sum of all cascades, never of each.
float surface_jacobian(float dxx, float dzz, float dxz) {
  return (1.0 + dxx) * (1.0 + dzz) - dxz * dxz;
}

// Slope in space from slope at fixed parameter: J^-T (sx, sz), with the cross term. The determinant
// is held at 0.15, so that a fold is steep and not infinite.
vec2 surface_slope(float sx, float sz, float dxx, float dzz, float dxz) {
  float jacobian = max(surface_jacobian(dxx, dzz, dxz), 0.15);
  return vec2((1.0 + dzz) * sx - dxz * sz, (1.0 + dxx) * sz - dxz * sx) / jacobian;
}

// Reflectance of flat water for unpolarised light from above (Fresnel); cosine in [0, 1].
float fresnel_water(float cosine) {
  float g = sqrt(kWaterIndex * kWaterIndex - 1.0 + cosine * cosine);
  float a = (g - cosine) / (g + cosine);
  float b = (cosine * (g + cosine) - 1.0) / (cosine * (g - cosine) + 1.0);
  return 0.5 * a * a * (1.0 + b * b);
}

// What water does to light, 1/m by linear RGB.
struct WaterOptics {
  vec3 absorption;
  vec3 scattering;
  vec3 backscatter;  // the part of the scattering that turns light back
};

// Sea water of open oceans by its chlorophyll (mg/m^3), at 630, 550 and 440 nm. Pure water: Pope & Fry
// 1997 (absorption), Morel 1974 (scattering, half of it backward). Plankton and yellow substance:
// Prieur & Sathyendranath 1981, Morel 1991. Particles: Loisel & Morel 1998, Morel & Maritorena 2001.
WaterOptics water_optics(float chlorophyll) {
  float plankton = 0.06 * pow(chlorophyll, 0.65);
  float logarithm = log(chlorophyll) / 2.302585092994046;
  float particles = 0.416 * pow(chlorophyll, 0.766);
  float backward = 0.002 + 0.01 * (0.5 - 0.25 * logarithm);
  float slope = chlorophyll < 2.0 ? 0.5 * (logarithm - 0.3) : 0.0;
  WaterOptics water;
  water.absorption = vec3((0.330 + 0.30 * plankton) * 1.014, (0.0565 + 0.357 * plankton) * 1.043,
                          (0.00635 + plankton) * 1.2);
  vec3 by_particles = particles * vec3(pow(1.13, slope), 1.0, pow(0.80, slope));
  water.scattering = by_particles + vec3(0.00120, 0.00194, 0.00490);
  water.backscatter = backward * by_particles + vec3(0.00060, 0.00097, 0.00245);
  return water;
}

// Share of a normal distribution below x: Abramowitz & Stegun 26.2.17, error below 7.5e-8.
float normal_below(float x) {
  float t = 1.0 / (1.0 + 0.2316419 * abs(x));
  float tail = 0.39894228040143268 * exp(-0.5 * x * x) * t *
               (0.319381530 + t * (-0.356563782 + t * (1.781477937 +
                t * (-1.821255978 + t * 1.330274429))));
  return x > 0.0 ? 1.0 - tail : tail;
}

// The x above which a normal distribution has this share, 0 < share < 1: Abramowitz & Stegun 26.2.22,
// error below 3e-3.
float normal_point(float share) {
  float t = sqrt(-2.0 * log(min(share, 1.0 - share)));
  float x = t - (2.30753 + 0.27061 * t) / (1.0 + t * (0.99229 + 0.04481 * t));
  return share > 0.5 ? -x : x;
}

// What an eye sees of facets whose slope toward it is normally distributed. With v the unit vector
// to the eye, a facet of slope s toward the eye shows the area (v_y + v_h s) where that is positive.
// level = v_y + v_h <s>, width = v_h sigma.
struct Facets {
  float area;   // mean of the shown area over facets (Smith's visible share times v_y)
  float slope;  // mean of (s - <s>) over what is shown, in units of sigma
};
Facets visible_facets(float level, float width) {
  Facets facets;
  float a = clamp(level / max(width, 1.0e-6), -4.0, 30.0);
  // normal_below(a), and the density that it needs as well.
  float density = 0.39894228040143268 * exp(-0.5 * a * a);
  float t = 1.0 / (1.0 + 0.2316419 * abs(a));
  float tail = density * t *
               (0.319381530 + t * (-0.356563782 + t * (1.781477937 +
                t * (-1.821255978 + t * 1.330274429))));
  float below = a > 0.0 ? 1.0 - tail : tail;
  float unit_area = a * below + density;  // E[(a + s)+] for unit sigma
  facets.area = max(width, 1.0e-6) * max(unit_area, 1.0e-7);
  if (a >= 30.0) facets.area = level;
  facets.slope = below / max(unit_area, 1.0e-7);  // E[s (a + s)+] / E[(a + s)+]
  return facets;
}

// The same share alone, level / area, to 1 %: the rational fit of Walter et al. 2007 to Smith's
// function of a = level / (sqrt(2) width).
float visible_share(float level, float width) {
  float a = max(0.70710678118654752 * level / max(width, 1.0e-6), 0.0);
  float hidden = a < 1.6 ? (1.0 - 1.259 * a + 0.396 * a * a) / (3.535 * a + 2.181 * a * a + 1.0e-6) : 0.0;
  return 1.0 / (1.0 + hidden);
}

// Share of scattered light that sea water turns into a direction, 1/sr, by the cosine of the angle that it
// is turned by: a fit, from 10 to 90 degrees, to Petzold's mean of measured particles as Mobley et al.
// tabulate it ("Comparison of numerical models for computing underwater light fields", Appl. Opt. 32, 1993).
float sea_water_phase(float cosine) {
  float x = inversesqrt(1.015 - cosine);
  return x * x * (0.00576 * x - 0.00121);
}

// Probability density of a slope, normal with the covariance xx, zz, xz (Cox & Munk 1954 without
// their skewness).
float slope_density(vec2 slope, float xx, float zz, float xz) {
  float det = max(xx * zz - xz * xz, 1.0e-12);
  float q = (zz * slope.x * slope.x - 2.0 * xz * slope.x * slope.y + xx * slope.y * slope.y) / det;
  return exp(-0.5 * q) / (2.0 * kWaterPi * sqrt(det));
}

// Share of the sea under whitecaps, Monahan & O'Muircheartaigh 1980; wind in m/s at 10 m.
float whitecap_share(float wind) { return min(3.84e-6 * pow(max(wind, 0.0), 3.41), 1.0); }
