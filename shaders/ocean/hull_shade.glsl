// The boat's shadow in the water. What glows under a pixel lies metres deep, red less than two and blue
// more than ten, and has been lit by rays that entered elsewhere: the deeper, the farther toward the light.
// Clear water therefore shows a wide, faint shadow and turbid water a sharp one. After boat/shadow.glsl,
// lib/water.glsl, and ocean/die.glsl where there are pixels.

const int kShadeDepths = 5;
const float kShadeDepth[kShadeDepths + 1] = float[](0.0, 0.5, 1.5, 4.0, 10.0, 25.0);  // m

// Share of the brighter light, by colour, that the water's glow keeps where it is seen at `water` (relative
// to the camera, m): over depths d with the weight 2K exp(-2K d), K the loss of hull_loss in 1/m.
vec3 hull_shade_below(vec3 water, vec3 view, vec3 light) {
  // Along both refracted rays, away from the eye and toward the light: metres for one of depth.
  const float kIndex2 = kWaterIndex * kWaterIndex;
  vec2 drift = light.xz * inversesqrt(kIndex2 - dot(light.xz, light.xz)) -
               view.xz * inversesqrt(kIndex2 - dot(view.xz, view.xz));
  vec3 last = water + kShadeDepth[kShadeDepths] * vec3(drift.x, 0.0, drift.y);
  if (boat_shadow_misses(water, last)) return vec3(1.0);

  float within = sea_die();
  vec3 reached = vec3(1.0);  // what comes from below a depth
  vec3 kept = vec3(0.0);
  for (int i = 0; i < kShadeDepths; ++i) {
    vec3 deeper = exp(-2.0 * ocean.hull_loss.rgb * kShadeDepth[i + 1]);
    vec3 entry = water;
    entry.xz += drift * mix(kShadeDepth[i], kShadeDepth[i + 1], within);
    kept += (reached - deeper) * boat_shade(entry);
    reached = deeper;
  }
  return kept + reached;
}
