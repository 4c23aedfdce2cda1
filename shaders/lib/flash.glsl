// Lightning as it lights what is outside its cloud: a glow about a direction. Needs shared/frame.h before it.
// `frame.flash_direction.w` is 1 - the cosine of half the angle it glows over, 0 where there is none.

// Radiance that a surface of this GGX width (alpha) mirrors from `direction`: a lobe whose integral over
// all directions is the flash's illuminance.
vec3 flash_mirrored(vec3 direction, float alpha) {
  float spread = frame.flash_direction.w + 0.5 * alpha * alpha;
  float off = 1.0 - dot(direction, frame.flash_direction.xyz);
  return frame.flash_illuminance.rgb * exp(-off / spread) / (2.0 * 3.14159265 * spread);
}

// Illuminance of a surface: as far as the glow reaches, it lights what faces away from its middle.
vec3 flash_illuminance(vec3 normal) {
  float beyond = sqrt(2.0 * frame.flash_direction.w);  // sine of half the angle, where that is small
  float facing = dot(normal, frame.flash_direction.xyz);
  return frame.flash_illuminance.rgb * max((facing + beyond) / (1.0 + beyond), 0.0);
}
