// Colour: linear sRGB (BT.709 primaries, white D65) unless a name says otherwise.

float colour_luminance(vec3 linear) {
  return dot(linear, vec3(0.2126, 0.7152, 0.0722));
}

// IEC 61966-2-1, exactly: both pieces, no power of 2.2.
float srgb_from_linear(float x) {
  return x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1.0 / 2.4) - 0.055;
}
float linear_from_srgb(float x) {
  return x <= 0.04045 ? x / 12.92 : pow((x + 0.055) / 1.055, 2.4);
}
vec3 srgb_from_linear(vec3 c) {
  return vec3(srgb_from_linear(c.x), srgb_from_linear(c.y), srgb_from_linear(c.z));
}
vec3 linear_from_srgb(vec3 c) {
  return vec3(linear_from_srgb(c.x), linear_from_srgb(c.y), linear_from_srgb(c.z));
}

// What the rods make of a colour, scaled so that white keeps its luminance (Larson, Rushmeier &
// Piatko 1997, eq. 10): blue counts for more, red for next to nothing.
float scotopic_luminance(vec3 linear) {
  float x = dot(linear, vec3(0.4124, 0.3576, 0.1805));
  float y = dot(linear, vec3(0.2126, 0.7152, 0.0722));
  float z = dot(linear, vec3(0.0193, 0.1192, 0.9505));
  const float kOfWhite = 2.5677;
  return max(y * (1.33 * (1.0 + (y + z) / max(x, 1.0e-12)) - 1.68), 0.0) / kOfWhite;
}

// The rods' share of sight at a luminance in cd/m^2: all below 0.003, none above 3 (the mesopic range,
// CIE 191).
float rod_share(float luminance) {
  float decades = log2(max(luminance, 1.0e-9)) * 0.30103;
  return 1.0 - smoothstep(-2.5, 0.5, decades);
}

// As seen with that share of rods: colours fade toward a dim blue, as painters and films have the
// night. `linear` may carry any exposure.
vec3 night_sight(vec3 linear, float rods) {
  vec3 blue = vec3(0.72, 1.00, 1.82) / dot(vec3(0.72, 1.00, 1.82), vec3(0.2126, 0.7152, 0.0722));
  return mix(linear, scotopic_luminance(linear) * blue, 0.8 * rods);
}
