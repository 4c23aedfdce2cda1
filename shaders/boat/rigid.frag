// A compact metallic-roughness surface: GGX and Lambert under sun and moon, sky above, sea below.
#include "shared/frame.h"
#include "shared/boat.h"
#include "lib/ggx.glsl"
#include "boat/light.glsl"

layout(binding = 0) uniform sampler2D base_picture;

in Surface {
  vec3 relative;
  vec3 normal;
  vec3 uv_coverage;
  vec4 ambient;  // lux; w: what the clouds leave of the sun
  vec3 air;      // cd/m^2
  flat vec4 base;      // as BoatMaterial
  flat vec4 emission;
} surface;

layout(location = 0) out vec4 radiance;

vec3 reflected(vec3 n, vec3 v, vec3 l, vec3 diffuse, vec3 f0, float alpha) {
  float n_dot_l = max(dot(n, l), 0.0);
  float n_dot_v = max(dot(n, v), 1.0e-3);
  vec3 h = normalize(l + v);
  float lobe = ggx_density(max(dot(n, h), 0.0), alpha) * ggx_visibility(n_dot_l, n_dot_v, alpha);
  return n_dot_l * (diffuse / kHalfTurn + schlick_fresnel(f0, max(dot(l, h), 0.0)) * lobe);
}

void main() {
  vec3 base = surface.base.rgb;
#ifdef PICTURE
  base *= texture(base_picture, surface.uv_coverage.xy).rgb;
#endif
  float metallic = surface.base.w;
  float alpha = surface.emission.w;
  vec3 diffuse = base * (1.0 - metallic);
  vec3 f0 = mix(vec3(0.04), base, metallic);

  vec3 n = normalize(surface.normal);
  vec3 v = -normalize(surface.relative);

  vec3 sum = vec3(0.0);
  for (int i = first_light(); i < last_light(); ++i) {
    vec3 l = light_direction(i);
    sum += light_illuminance(i) * surface.ambient.w * light_share(i, surface.relative, n) *
           reflected(n, v, l, diffuse, f0, alpha);
  }

  // Sky and sea: diffuse from all round, glossy from about the mirror direction.
  sum += diffuse / kHalfTurn * surface.ambient.rgb;
  vec3 glossy = probe_radiance(reflect(-v, n), sqrt(alpha));
  float m = 1.0 - max(dot(n, v), 0.0);
  // Reflectance of a rough surface over all directions (S. Lagarde 2011, "Adopting a physically based
  // shading model").
  vec3 reflectance = f0 + (max(vec3(1.0 - alpha), f0) - f0) * m * m * m * m * m;
  sum += reflectance * glossy;

  sum = through_air(sum + surface.emission.rgb, surface.relative, surface.air);
  radiance = vec4(min(sum * frame.time.z, vec3(6.0e4)), surface.uv_coverage.z);
}
