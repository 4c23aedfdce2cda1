// What shows by night: stars that twinkle, the moon and the earth's shadow on it. Compiled as GLSL and as
// double-precision C++. Needs lib/phase.glsl before it.

// Degrees by which air lifts what stands at this true elevation (degrees, not below -2)
// (Saemundsson 1986, for 1010 hPa and 10 degrees).
float star_refraction(float elevation) {
  float e = max(elevation, -2.0);
  return max(1.02 / 60.0 / tan(radians(e + 10.3 / (e + 5.11))), 0.0);
}

// How much air a star is seen through, 1 at the zenith (Rozenberg 1966).
float air_mass(float cosine) {
  float c = max(cosine, 0.0);
  return 1.0 / (c + 0.025 * exp(-11.0 * c));
}

// Brightness of a twinkling star over its mean: four waves, of 2 to 9 a second, with phases of its own.
// The depth grows with the 1.75th power of the air mass until it saturates (Dravins et al. 1997, §5).
// `seed` 0 to 1, `time` in s; all frequencies are multiples of 1/4096 Hz, so that a time that starts
// anew after 4096 s shows no jump. `shift`, in turns, sets colours apart.
float twinkle(float time, float seed, float mass, float shift) {
  float depth = min(0.035 * pow(mass, 1.75), 0.7);
  float sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    float n = float(i) + fract(seed * (7.31 + 3.7 * float(i)));
    float frequency = floor((2.0 + 1.75 * n) * 4096.0) / 4096.0;
    sum += sin(2.0 * kPhasePi * (fract(time * frequency) + fract(seed * (91.7 + 17.3 * float(i))) + shift));
  }
  return 1.0 + depth * 0.25 * sum;
}

// Light of a Lommel–Seeliger sphere by phase angle (radians), 1 when full (Fairbairn 2005, eq. 9).
float lommel_seeliger_phase(float angle) {
  float half_angle = clamp(0.5 * abs(angle), 1.0e-4, 0.5 * kPhasePi - 1.0e-4);
  return max(1.0 + sin(half_angle) * tan(half_angle) * log(tan(0.5 * half_angle)), 0.0);
}

// Of moonlight, linear sRGB of luminance 1: the dusty rock reddens the sun's light a little.
vec3 moon_colour() { return vec3(1.06, 1.0, 0.86) / 1.00265; }

// Share of sunlight, linear sRGB, that reaches a point of the moon this far from the axis of the earth's
// shadow; all in one unit. In the penumbra the earth's limb crosses the sun's disc as a straight line
// would. In the umbra what the earth's ring of air bends in: copper, with a blue rim where only ozone
// lets light pass, 1e-3 of sunlight falling to 2e-5 (a total eclipse of Danjon's 2 to 3).
vec3 earth_shadow(float distance, float umbra, float penumbra) {
  float x = clamp(2.0 * (distance - umbra) / (penumbra - umbra) - 1.0, -1.0, 1.0);
  float direct = 0.5 + (asin(x) + x * sqrt(max(1.0 - x * x, 0.0))) / kPhasePi;
  float inward = clamp(1.0 - distance / umbra, 0.0, 1.0);
  vec3 copper = mix(vec3(1.10, 1.02, 1.00), vec3(2.60, 0.58, 0.22), smoothstep(0.0, 0.3, inward));
  float bent = exp(mix(log(1.0e-3), log(2.0e-5), inward));
  return vec3(direct) + (1.0 - direct) * bent * copper;
}

// The sun's corona at a distance from the centre in solar radii, over the mean brightness of the disc
// (Baumbach 1937; Allen 1976).
float corona(float radii) {
  float r = max(radii, 1.0);
  return 1.0e-6 * (0.0532 * pow(r, -2.5) + 1.425 * pow(r, -7.0) + 2.565 * pow(r, -17.0));
}
