// Lightning as it lights what is outside its cloud: a glow about a direction. Needs shared/frame.h before it.
// `frame.flash_direction.w` is 1 - the cosine of half the angle it glows over, 0 where there is none.

// Other clouds and the air send on a tenth or so of what comes, from all of the sky.
const float kFlashEven = 0.1;

// Radiance that a surface of this GGX width (alpha) mirrors from `direction`: a lobe whose integral over
// all directions is the flash's illuminance, and the even share.
vec3 flash_mirrored(vec3 direction, float alpha) {
  float spread = frame.flash_direction.w + 0.5 * alpha * alpha;
  float off = 1.0 - dot(direction, frame.flash_direction.xyz);
  float even = direction.y > 0.0 ? 2.0 * kFlashEven : 0.0;
  return frame.flash_illuminance.rgb * (exp(-off / spread) / spread + even) / (2.0 * 3.14159265);
}

// Illuminance of a surface: as far as the glow reaches, it lights what faces away from its middle.
vec3 flash_illuminance(vec3 normal) {
  float beyond = sqrt(2.0 * frame.flash_direction.w);  // sine of half the angle, where that is small
  float facing = dot(normal, frame.flash_direction.xyz);
  float even = kFlashEven * (0.5 + 0.5 * normal.y);
  return frame.flash_illuminance.rgb * (max((facing + beyond) / (1.0 + beyond), 0.0) + even);
}
