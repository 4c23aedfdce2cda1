// Light in the sea: how water of a given clarity dims it, how the surface bends it, how waves gather it.
// Compiled as GLSL and as double-precision C++. Lengths in m, coefficients in 1/m by linear sRGB.
// Needs lib/phase.glsl and lib/water.glsl before it.

// ---- What water does to light --------------------------------------------------------------------

// What a thin beam, and with it the contrast of small things, loses on its way (Duntley 1963).
vec3 beam_attenuation(WaterOptics water) { return water.absorption + water.scattering; }

// What a picture loses: light that is scattered forward by little still belongs to a thing as wide as a
// hull, and only the outline of small ones blurs. Half of the scattering is left at some 4 cycles per
// radian (Wells 1973: b (1 - exp(-x)) / x with x = 2 pi .07 cycles).
vec3 picture_attenuation(WaterOptics water) { return water.absorption + 0.5 * water.scattering; }

// How daylight fades with depth (Gordon 1989): 1.0395 D0 (a + bb), with D0 the mean way of the light
// per metre of depth just below the surface.
vec3 diffuse_attenuation(WaterOptics water, float way) {
  return 1.0395 * way * (water.absorption + water.backscatter);
}
// D0 of light from a sky that is the same all round.
const float kDiffuseWay = 1.197;

// Depth at which a white disc is lost to an eye above the water (Tyler 1968), in green light.
float secchi_depth(WaterOptics water) {
  return 8.7 / (beam_attenuation(water).y + diffuse_attenuation(water, kDiffuseWay).y);
}

// Irradiance that comes back up over what goes down (Gordon, Brown & Jacobs 1975).
vec3 irradiance_reflectance(WaterOptics water) {
  return 0.33 * water.backscatter / (water.absorption + water.backscatter);
}

// Integral of exp(-k t) from 0 to s.
vec3 path_integral(vec3 k, float s) {
  vec3 whole = k * s;
  // Below 1e-3 the quotient loses digits; its series has an error of whole^2 / 6.
  vec3 safe = max(abs(whole), vec3(1.0e-3)) * (step(vec3(0.0), whole) * 2.0 - 1.0);
  vec3 quotient = (vec3(1.0) - exp(-safe)) / safe;
  vec3 series = vec3(1.0) - 0.5 * whole;
  return s * mix(quotient, series, vec3(lessThan(abs(whole), vec3(1.0e-3))));
}

// How light from `cosine` (1: one looks straight into it) is scattered toward the eye over how light
// from behind the eye is. Sea water scatters forward; g: mean cosine after the few scatterings that
// matter.
float scattering_shape(float g, float cosine) {
  return henyey_greenstein(g, cosine) / henyey_greenstein(g, -0.9);
}
const float kSunG = 0.80;  // of a beam
const float kSkyG = 0.60;  // of light from all of the window

// ---- The surface from below -----------------------------------------------------------------------

// Reflectance of water for unpolarised light from below: by reciprocity that of the refracted ray from
// above, 1 beyond the critical angle.
float fresnel_from_below(float cosine) {
  float sine2 = kWaterIndex * kWaterIndex * (1.0 - cosine * cosine);
  return sine2 >= 1.0 ? 1.0 : fresnel_water(sqrt(1.0 - sine2));
}

// What a rough surface lets through from below to above. Facets' slopes toward the eye are normal about
// the one that is seen at `cosine`, with the deviation `sigma`; those within the critical angle pass
// light. The edge of the window is as soft as they are rough.
struct Window {
  float passing;  // share of the light
  float cosine;   // of the mean facet that passes it
};
Window window_through(float cosine, float sigma) {
  float edge = sqrt(1.0 - 1.0 / (kWaterIndex * kWaterIndex));
  // There the cosine changes by the sine, 1 / n, for a change of the slope.
  float width = max(sigma / kWaterIndex, 1.0e-3);
  float level = cosine - edge;
  float share = normal_below(level / width);
  Window window;
  window.cosine = clamp(edge + visible_facets(level, width).area / max(share, 1.0e-4), edge, 1.0);
  window.passing = share * (1.0 - fresnel_from_below(window.cosine));
  return window;
}

// A light above level water, as it shines below.
struct BentLight {
  vec3 toward;     // unit, toward the light
  float passing;   // illuminance on a plane that faces it there, over that above
};
BentLight bent_light(vec3 toward) {
  float cosine = max(toward.y, 0.0);
  BentLight light;
  light.toward = vec3(toward.x / kWaterIndex, 0.0, toward.z / kWaterIndex);
  light.toward.y = sqrt(1.0 - light.toward.x * light.toward.x - light.toward.z * light.toward.z);
  light.passing = (1.0 - fresnel_water(cosine)) * cosine / light.toward.y;
  return light;
}

// Radiance (1/sr) of a small light seen from the water through facets of which `density` per unit
// of slope bend it to the eye: Walter et al. 2007, eq. 21, with D = density / n_y^4. `down`: unit,
// from the surface to the eye (y < 0); `toward`: unit, to the light.
struct BentGlitter {
  vec2 slope;     // of the facets that do it
  float radiance; // over illuminance and density
};
BentGlitter bent_glitter(vec3 down, vec3 toward) {
  vec3 facet = -(toward + kWaterIndex * down);
  BentGlitter g;
  // Into the water the bisector points to the denser side: turn it up.
  facet = facet.y < 0.0 ? -facet : facet;
  float sum = length(facet);
  vec3 n = facet / max(sum, 1.0e-4);
  float up = max(n.y, 0.05);
  g.slope = vec2(-n.x, -n.z) / up;
  float light = dot(toward, n), eye = -dot(down, n);
  bool passes = light > 0.0 && eye > 0.0;
  float level = max(-down.y, 0.05);
  float spread = light - kWaterIndex * eye;
  float share = kWaterIndex * kWaterIndex * (1.0 - fresnel_water(clamp(light, 0.0, 1.0))) * light *
                eye / (level * max(spread * spread, 1.0e-3) * up * up * up * up);
  g.radiance = passes ? share : 0.0;
  return g;
}

// ---- Caustics -------------------------------------------------------------------------------------

// A ray of a light through the waves: where it crosses the depth `below` (m under the mean level), seen
// back along the level sea's ray, relative to where it met the surface at rest; and what it carries
// per area of water at rest, over what level water would let through. The mean of that over a
// sea is 1 but for Fresnel's losses, since light falls on a sea however it is shaped.
struct Photon {
  float carried;
  vec2 way;  // horizontal, m per m of depth
};
Photon photon(vec3 toward, vec2 slope, float jacobian) {
  vec3 normal = normalize(vec3(-slope.x, 1.0, -slope.y));
  float cosine = dot(toward, normal);
  float lit = max(cosine, 0.0);
  float bent = sqrt(1.0 - (1.0 - lit * lit) / (kWaterIndex * kWaterIndex));
  vec3 ray = -toward / kWaterIndex + (lit / kWaterIndex - bent) * normal;
  float level = max(toward.y, 0.02);
  Photon p;
  p.carried = max(jacobian, 0.0) * lit / (normal.y * level) * (1.0 - fresnel_water(lit)) /
              (1.0 - fresnel_water(level));
  p.way = vec2(ray.x, ray.z) / max(-ray.y, 0.1);
  return p;
}
