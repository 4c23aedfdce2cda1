// What the fragment shaders of the background share. Needs shared/frame.h.
// Toward this pixel.
vec3 pixel_direction() {
  vec2 corner = gl_FragCoord.xy * frame.viewport.zw * 2.0 - 1.0;
  vec4 near = frame.relative_from_clip * vec4(corner, 1.0, 1.0);
  return normalize(near.xyz);  // (w is positive)
}

const float kBrightest = 30000.0;  // two of them still fit a half float
