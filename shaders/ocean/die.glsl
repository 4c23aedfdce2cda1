// Interleaved gradient noise (Jimenez 2014), even over 0 … 1: neighbouring pixels differ as much as they can.
float sea_die() {
  return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
}
