// The painted sky (engine/sky/palette.h): alone, or as the colour of what the air makes. Needs
// shared/sky.h.
vec3 painted_sky_radiance(vec3 direction, vec3 physical) {
  float above = direction.y * sky.observer.z + length(direction.xz) * sky.observer.y;
  float w = sqrt(clamp(above, 0.0, 1.0));
  vec3 painted = (1.0 - w) * (1.0 - w) * sky.palette_horizon.rgb +
                 2.0 * w * (1.0 - w) * sky.palette_middle.rgb + w * w * sky.palette_zenith.rgb;
  vec3 graded = mix(physical, dot(physical, vec3(0.2126, 0.7152, 0.0722)) * painted, sky.lights.y);
  return mix(painted, graded, sky.lights.z);
}
