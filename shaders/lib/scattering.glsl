// The air: what it holds at a height, and the geometry of rays in a spherical shell.
//
// Lengths in km, coefficients per km, as linear sRGB. A place is its height over the sea, a direction
// its cosine with the zenith there: heights instead of radii keep single precision exact to
// centimetres near the sea (a radius of 6360 km has steps of half a metre).
//
// Constants of the demo of Hillaire, "A Scalable and Production Ready Sky and Atmosphere Rendering
// Technique", EGSR 2020: Rayleigh and Mie exponential in height, ozone in a tent round 25 km.
const float kPlanetRadius = 6360.0;
const float kAirTop = 100.0;
const float kRayleighHeight = 8.0;
const float kOzoneCentre = 25.0;
const float kOzoneHalfWidth = 15.0;
const float kMieG = 0.8;
const float kSeaAlbedo = 0.06;  // of the sea for light from all sides

vec3 rayleigh_at_sea_level() { return vec3(0.005802, 0.013558, 0.033100); }
vec3 ozone_absorption() { return vec3(0.000650, 0.001881, 0.000085); }

// The part of the air that changes with the weather.
struct Aerosol {
  float scattering;  // per km at sea level
  float extinction;
  float scale_height;  // km
};

// Haze 0 is Hillaire's clear air (a visibility of hundreds of km), 0.1 a clear day at sea, 0.5 some
// 7 km, 1 fog of 250 m that lies low. In between both the logarithm of the density and that of its
// height run smoothly; haze comes down to the water only as it turns to fog. What comes on top of the
// clear air is salt and droplets: they hardly absorb.
Aerosol aerosol_of_haze(float haze) {
  const float kClearExtinction = 0.004440;
  const float kClearScattering = 0.003996;
  const float kFogExtinction = 15.6;
  const float kFogHeight = 0.05;
  const float kClearHeight = 1.2;
  const float kDropletAlbedo = 0.995;
  float amount = pow(clamp(haze, 0.0, 1.0), 0.75);
  Aerosol a;
  a.extinction = kClearExtinction * pow(kFogExtinction / kClearExtinction, amount);
  a.scattering = kClearScattering + kDropletAlbedo * (a.extinction - kClearExtinction);
  float lowness = clamp(haze, 0.0, 1.0) * clamp(haze, 0.0, 1.0);
  a.scale_height = kClearHeight * pow(kFogHeight / kClearHeight, lowness);
  return a;
}

// The three values stand for light of 680, 550 and 440 nm, and transport is worked out there. Green and
// blue of a display lie close by; its red lies near 628 nm, where ozone takes three times as much.
// Shown as they are, the bands make dusk purple that is blue in nature. So red is read off there from
// a spectrum whose logarithm (over the sun's) is a constant, the logarithm of the wavelength and
// ozone's cross-section. Light without colour keeps none; doubled light is doubled.
vec3 srgb_from_bands(vec3 bands) {
  vec3 l = log(max(bands, vec3(1.0e-25)));
  float red = exp(dot(l, vec3(0.3057, 0.9979, -0.3036)));
  return vec3(min(red, max(max(bands.x, bands.y), bands.z)), bands.y, bands.z);
}

struct Air {
  vec3 rayleigh;  // scattering
  vec3 mie;
  vec3 extinction;
};

Air air_at(Aerosol aerosol, float height) {
  float h = max(height, 0.0);
  float mie = exp(-h / aerosol.scale_height);
  float ozone = max(0.0, 1.0 - abs(h - kOzoneCentre) / kOzoneHalfWidth);
  Air air;
  air.rayleigh = exp(-h / kRayleighHeight) * rayleigh_at_sea_level();
  air.mie = vec3(mie * aerosol.scattering);
  air.extinction = air.rayleigh + vec3(mie * aerosol.extinction) + ozone * ozone_absorption();
  return air;
}

// ---- Rays ---------------------------------------------------------------------------------------

// Height after a distance along a ray. The difference of two radii, without subtracting them.
float height_along(float height, float cosine, float along) {
  float r = kPlanetRadius + height;
  float rise = height * (2.0 * kPlanetRadius + height) + along * (along + 2.0 * r * cosine);
  return rise / (sqrt(max(kPlanetRadius * kPlanetRadius + rise, 0.0)) + kPlanetRadius);
}

// The cosine of the zenith angle of a direction there: `towards` is its cosine with the ray,
// `cosine_start` its cosine with the zenith where the ray starts.
float cosine_along(float height, float cosine_start, float towards, float along, float height_there) {
  return clamp(((kPlanetRadius + height) * cosine_start + along * towards) /
                   (kPlanetRadius + height_there),
               -1.0, 1.0);
}

// The sine of the dip of the sea's horizon: it lies this far below the level.
float horizon_dip_sine(float height) {
  return sqrt(height * (2.0 * kPlanetRadius + height)) / (kPlanetRadius + height);
}

float distance_to_top(float height, float cosine) {
  float b = (kPlanetRadius + height) * cosine;
  float c = (kAirTop - height) * (2.0 * kPlanetRadius + kAirTop + height);
  float root = sqrt(max(b * b + c, 0.0));
  return cosine > 0.0 ? c / (root + b) : root - b;
}

// Negative where the ray misses the sea.
float distance_to_sea(float height, float cosine) {
  float b = (kPlanetRadius + height) * cosine;
  float c = height * (2.0 * kPlanetRadius + height);
  float d = b * b - c;
  return cosine < 0.0 && d >= 0.0 ? c / (sqrt(d) - b) : -1.0;
}

// The share of a sun or moon of this angular radius (radians) that stands above the sea's horizon,
// for its centre at this cosine. The exact area of a disc cut by a straight line.
float share_above_horizon(float height, float cosine, float radius) {
  float dip = asin(min(horizon_dip_sine(height), 1.0));
  float x = clamp((asin(clamp(cosine, -1.0, 1.0)) + dip) / radius, -1.0, 1.0);
  return 0.5 + (asin(x) + x * sqrt(max(1.0 - x * x, 0.0))) / kPhasePi;
}

// Its rounded stand-in for marches: no arc functions.
float soft_share_above_horizon(float height, float cosine, float radius) {
  return smoothstep(-radius, radius, cosine + horizon_dip_sine(height));
}

// ---- Transmittance ------------------------------------------------------------------------------

// Optical depth from the lowest point of a straight ray, `along` km outward. The steps grow with the
// cube of their number: fog 200 m deep and air 100 km deep both get enough.
vec3 optical_depth_outward(Aerosol aerosol, float height, float cosine, float along, int steps) {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < steps; ++i) {
    float x = (float(i) + 0.5) / float(steps);
    Air air = air_at(aerosol, height_along(height, cosine, along * x * x * x));
    sum += air.extinction * (3.0 * x * x);
  }
  return sum * (along / float(steps));
}

// From a height to the top of the air, as if no planet were in the way.
vec3 transmittance_to_top(Aerosol aerosol, float height, float cosine, int steps) {
  if (cosine >= 0.0) {
    float along = distance_to_top(height, cosine);
    return exp(-optical_depth_outward(aerosol, height, cosine, along, steps));
  }
  // Down to the ray's lowest point and up again on the other side of it.
  float back = -(kPlanetRadius + height) * cosine;
  float lowest = max(height_along(height, cosine, back), 0.0);
  vec3 depth = optical_depth_outward(aerosol, lowest, 0.0, back, steps) +
               optical_depth_outward(aerosol, lowest, 0.0, distance_to_top(lowest, 0.0), steps);
  return exp(-depth);
}

// ---- Tables -------------------------------------------------------------------------------------

// Texture coordinate of a value 0 to 1 whose ends lie in the centres of the first and last texel.
float table_from_unit(float unit, float texels) { return 0.5 / texels + unit * (1.0 - 1.0 / texels); }
float unit_from_table(float coordinate, float texels) {
  return clamp((coordinate - 0.5 / texels) / (1.0 - 1.0 / texels), 0.0, 1.0);
}

struct HeightCosine {
  float height;
  float cosine;
};

// Transmittance (Bruneton & Neyret 2008, §4): x by the distance to the top between its least and its
// most, which is the horizon; y by the distance to the horizon.
vec2 transmittance_units(float height, float cosine) {
  float whole = sqrt(kAirTop * (2.0 * kPlanetRadius + kAirTop));
  float rho = sqrt(max(height * (2.0 * kPlanetRadius + height), 0.0));
  float nearest = kAirTop - height;
  float d = distance_to_top(height, cosine);
  return vec2(clamp((d - nearest) / (rho + whole - nearest), 0.0, 1.0), clamp(rho / whole, 0.0, 1.0));
}
HeightCosine transmittance_place(vec2 units) {
  float whole = sqrt(kAirTop * (2.0 * kPlanetRadius + kAirTop));
  float rho = units.y * whole;
  HeightCosine place;
  place.height = rho * rho / (sqrt(rho * rho + kPlanetRadius * kPlanetRadius) + kPlanetRadius);
  float nearest = kAirTop - place.height;
  float d = nearest + units.x * (rho + whole - nearest);
  float c = whole * whole - rho * rho;
  place.cosine =
      d <= 0.0 ? 1.0 : clamp((c - d * d) / (2.0 * d * (kPlanetRadius + place.height)), -1.0, 1.0);
  return place;
}

// Multiple scattering: x by the sun's cosine, fine about the horizon where it changes by decades and
// ending at -0.36, beyond which no part of the air is lit; y by the root of the height.
const float kDarkestCosine = -0.36;
vec2 multiscatter_units(float height, float cosine) {
  float side = cosine >= 0.0 ? sqrt(cosine) : -sqrt(min(cosine / kDarkestCosine, 1.0));
  return vec2(0.5 + 0.5 * side, sqrt(clamp(height / kAirTop, 0.0, 1.0)));
}
HeightCosine multiscatter_place(vec2 units) {
  float side = 2.0 * units.x - 1.0;
  HeightCosine place;
  place.cosine = side >= 0.0 ? side * side : kDarkestCosine * side * side;
  place.height = kAirTop * units.y * units.y;
  return place;
}

// Sky view: the sky above the sea's horizon for one light. x by the sine of half the azimuth from the
// light (even about it and about its opposite, so that no seam shows), y by the angle above the
// horizon, fine at the horizon as its square root. No arc functions: w = sqrt(1 - sine) is linear in
// the angle from the zenith.
vec2 sky_view_units(float cosine_azimuth, float sine_above_horizon) {
  float w = sqrt(clamp(1.0 - sine_above_horizon, 0.0, 1.0));
  return vec2(sqrt(clamp(0.5 - 0.5 * cosine_azimuth, 0.0, 1.0)), sqrt(1.0 - w));
}
struct SkyViewPlace {
  float cosine_azimuth;
  float sine_above_horizon;
};
SkyViewPlace sky_view_place(vec2 units) {
  float w = 1.0 - units.y * units.y;
  SkyViewPlace place;
  place.cosine_azimuth = 1.0 - 2.0 * units.x * units.x;
  place.sine_above_horizon = 1.0 - w * w;
  return place;
}

// In a total eclipse the air outside the moon's shadow is lit, and is seen low all round: its brightness over
// that at the horizon, by the sine above it, and the level illuminance of such a band (its integral).
const float kUmbraBandHeight2 = 0.011;  // the square of the sine at which it has fallen to a quarter
const float kUmbraBandIlluminance = kPhasePi * kUmbraBandHeight2 / (1.0 + kUmbraBandHeight2);
float umbra_band(float sine_above_horizon) {
  float share = kUmbraBandHeight2 / (kUmbraBandHeight2 + sine_above_horizon * sine_above_horizon);
  return share * share;
}

// ---- Sun, moon and the night's own light ---------------------------------------------------------

// Brightness across the disc over its mean, from the centre (0) to the limb (1), linear sRGB
// (Hestroffer & Magnan 1998, interpolated to 680, 550 and 440 nm).
vec3 limb_darkening(float from_centre) {
  vec3 power = vec3(0.397, 0.503, 0.652);
  float mu = sqrt(clamp(1.0 - from_centre * from_centre, 1.0e-6, 1.0));
  return pow(vec3(mu), power) * (1.0 + 0.5 * power);
}

// The moon's light over that of the full moon, by phase angle in degrees: far below the lit fraction,
// since its soil throws light back (Allen 1976; Krisciunas & Schaefer 1991, eq. 9).
float moon_phase_brightness(float angle) {
  float a = abs(angle);
  return pow(10.0, -0.4 * (0.026 * a + 4.0e-9 * a * a * a * a));
}

// How much more glowing air one looks through toward this cosine than toward the zenith; the layer
// lies 87 km high (van Rhijn 1921).
float van_rhijn(float cosine) {
  float s2 = (1.0 - cosine * cosine) * 0.97319;  // (R / (R + 87 km))^2
  return inversesqrt(max(1.0 - s2, 1.0e-3));
}
