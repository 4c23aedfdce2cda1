// The sky at the horizon, by heading: a strip, so that the sea's pixels need not look it up in the sky's
// tables. Headings go round a square, not a circle: no trigonometry.

// Place of a level heading (x, z; any length) in the strip, 0 to 1.
float horizon_place(vec2 heading) {
  float x = heading.x / max(abs(heading.x) + abs(heading.y), 1.0e-12);
  return heading.y >= 0.0 ? 0.25 - 0.25 * x : 0.75 + 0.25 * x;
}

// The heading of a place, not of unit length.
vec2 horizon_heading(float place) {
  float x = place < 0.5 ? 1.0 - 4.0 * place : 4.0 * place - 3.0;
  return vec2(x, place < 0.5 ? 1.0 - abs(x) : abs(x) - 1.0);
}
