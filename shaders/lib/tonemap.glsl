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

// Channel by channel, after a little of each has spilled into the others: what is far too bright ends
// in white instead of a flat primary.
vec3 tonemap_filmic(vec3 linear) {
  const float kSpill = 0.055;
  float mean = (linear.x + linear.y + linear.z) / 3.0;
  vec3 x = max(mix(linear, vec3(mean), kSpill), vec3(0.0));
  return vec3(filmic_curve(x.x), filmic_curve(x.y), filmic_curve(x.z));
}

// Noise of ± half a step of an 8-bit display, different from pixel to pixel with little energy in what
// the eye sees from afar (Jimenez, "Next generation post processing in Call of Duty", 2014). Added
// before rounding it turns bands into grain too fine to see.
float dither(vec2 pixel) {
  return (fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0;
}
