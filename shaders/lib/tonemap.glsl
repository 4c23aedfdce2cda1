// From radiance × exposure to what a display shows, 0 to 1 and still linear.

// The simple one: the share of an emulsion's grains that light has hit.
vec3 tonemap_exponential(vec3 x) { return vec3(1.0) - exp(-max(x, vec3(0.0))); }

// A filmic curve of toe, straight middle and shoulder (Uchimura, "HDR theory and practice", CEDEC
// 2017), with a longer shoulder than his for skies.
const float kToneContrast = 1.0;
const float kToneMiddle = 0.22;    // where the straight part begins
const float kToneStraight = 0.28;  // its length
const float kToneToe = 1.22;       // power of the toe
float filmic_curve(float x) {
  float straight = (1.0 - kToneMiddle) * kToneStraight / kToneContrast;
  float end_in = kToneMiddle + straight;
  float end_out = kToneMiddle + kToneContrast * straight;
  float toe = kToneMiddle * pow(max(x, 0.0) / kToneMiddle, kToneToe);
  float middle = kToneMiddle + kToneContrast * (x - kToneMiddle);
  float shoulder =
      1.0 - (1.0 - end_out) * exp(-kToneContrast * (x - end_in) / (1.0 - end_out));
  float weight_toe = 1.0 - smoothstep(0.0, kToneMiddle, x);
  return x > end_in ? shoulder : mix(middle, toe, weight_toe);
}

// The same curve with sRGB after it, as a display's value 0 to 1: two polynomials of degree 7 in
// sqrt(x / (1 + x)), fitted to within .22 of a step of 255. Three powers and an exponential less.
float filmic_display(float x) {
  float v = min(sqrt(x / (1.0 + x)), 0.97);
  bool dark = v < 0.36;
  float t = dark ? v / 0.18 - 1.0 : (v - 0.665) / 0.305;
  float y = dark ? 0.07322459 : 0.07100698;
  y = y * t + (dark ? -0.001501791 : -0.0269393);
  y = y * t + (dark ? -0.1589551 : -0.06969741);
  y = y * t + (dark ? 0.03650044 : 0.09206947);
  y = y * t + (dark ? 0.06363019 : -0.08724028);
  y = y * t + (dark ? 0.01096795 : -0.2117694);
  y = y * t + (dark ? 0.2311341 : 0.3776589);
  y = y * t + (dark ? 0.1639129 : 0.8556724);
  return clamp(y, 0.0, 1.0);
}

// A little of each channel spills into the others before the curve: what is far too bright ends in
// white instead of a flat primary.
vec3 spilled(vec3 linear) {
  const float kSpill = 0.055;
  float mean = (linear.x + linear.y + linear.z) / 3.0;
  return max(mix(linear, vec3(mean), kSpill), vec3(0.0));
}
vec3 tonemap_filmic(vec3 linear) {
  vec3 x = spilled(linear);
  return vec3(filmic_curve(x.x), filmic_curve(x.y), filmic_curve(x.z));
}
vec3 display_filmic(vec3 linear) {
  vec3 x = spilled(linear);
  return vec3(filmic_display(x.x), filmic_display(x.y), filmic_display(x.z));
}

// Noise of ± half a step of an 8-bit display, different from pixel to pixel with little energy in what
// the eye sees from afar (Jimenez, "Next generation post processing in Call of Duty", 2014). Added
// before rounding it turns bands into grain too fine to see.
float dither(vec2 pixel) {
  return (fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0;
}
