// Gardner's cumulus: ellipsoids whose shading (8) and translucency (11) his texture function varies.
#include "shared/frame.h"
#include "sky/sky.glsl"
#include "sky/pixel.glsl"
#include "clouds/far_air.glsl"
#include "lib/gardner.glsl"
#include "shared/gardner.h"

in Ellipsoid {
  vec3 direction;
  flat vec3 centre;
  flat vec4 radii;
} ellipsoid;

layout(location = 0) out vec4 colour;

void main() {
  vec3 d = normalize(ellipsoid.direction);
  GardnerHit hit = gardner_hit(-ellipsoid.centre / ellipsoid.radii.xyz, d / ellipsoid.radii.xyz);
  if (hit.limb <= 0.0) discard;
  vec3 p = d * max(hit.along, 0.0);
  vec3 normal = normalize((p - ellipsoid.centre) / (ellipsoid.radii.xyz * ellipsoid.radii.xyz));
  float distance = length(p);
  vec3 at = (gardner.pattern.xyz + p * gardner.pattern.w).xzy;
  float value = gardner_texture(at, int(gardner.translucency.w), gardner.shading.w,
                                distance * frame.camera.w * gardner.pattern.w);
  float through = gardner_limb_translucency(value, hit.limb, gardner.translucency.x,
                                            gardner.translucency.y, gardner.translucency.z);
  // Flat bases: a cloud ends where its air is no longer saturated.
  float altitude = frame.camera.y + p.y + dot(p.xz, p.xz) * 0.5e-3 / kPlanetRadius;
  through = mix(1.0, through, smoothstep(-60.0, 60.0, altitude - ellipsoid.radii.w));

  vec3 toward = gardner.light_direction.xyz;
  float facing = dot(normal, toward);
  float diffuse = max(facing, 0.0);
  float specular = pow(max(dot(reflect(d, normal), toward), 0.0), 8.0);
  // (8) with the ambient share taken out: that light has its own colour.
  float shade = gardner_shade(diffuse, specular, value * step(0.0, facing + 0.4), 0.0, gardner.shading.y,
                              gardner.shading.z);
  vec3 light = gardner.light_source.rgb * light_aloft(altitude, p.xz, toward);
  vec3 ambient = sky_irradiance(normal) * (1.0 + gardner.shading.x);
  vec3 radiance = (0.85 * (1.0 - gardner.shading.x) * light * shade + ambient) / kPhasePi;
  AirLight air = air_before(altitude, p.xz, vec3(d.x, max(d.y, -sky.observer.y), d.z));
  vec3 seen = radiance * air.transmittance + air.inscattered;
  colour = vec4(min(seen * (1.0 - through) * frame.time.z, vec3(kBrightest)), through);
}
