// Cirrus and cirrostratus: a thin layer of ice drawn as Gardner's sky plane (1), (3)-(6), (9). The plane
// is bent with the earth, so that it ends behind the horizon. Multiplied and added onto the sky.
#include "shared/frame.h"
#include "sky/sky.glsl"
#include "sky/pixel.glsl"
#include "clouds/far_air.glsl"
#include "lib/phase_cloud.glsl"
#include "lib/cloud_scattering.glsl"
#include "lib/gardner.glsl"
#include "shared/gardner.h"

layout(location = 0) out vec4 colour;

// Crystals scatter forward, some a great deal; plates and columns bend light by 22 degrees.
const float kIceG = 0.76;
float ice_phase(float cosine) {
  const float kHalo = 0.9272;       // cosine of 22 degrees
  const float kHaloWidth = 0.0055;  // in cosine: near one degree
  const float kHaloShare = 0.012;
  float off = (cosine - kHalo) / kHaloWidth;
  // Sharp inside, soft outside.
  off *= off > 0.0 ? 1.6 : 0.55;
  float area = 2.506628 * kHaloWidth * 0.5 * (1.0 / 1.6 + 1.0 / 0.55);
  float halo = exp(-0.5 * off * off) / (2.0 * kPhasePi * area);
  float body = mix(silver_lining(0.76, 0.12, 0.03, cosine), henyey_greenstein(-0.2, cosine), 0.1);
  return mix(body, halo, kHaloShare);
}

void main() {
  vec3 d = pixel_direction();
  float rise = gardner.high.w - frame.camera.y;
  float curvature = 0.5e-3 / kPlanetRadius;
  float flat2 = max(1.0 - d.y * d.y, 0.0);
  float along = 2.0 * rise / (d.y + sqrt(d.y * d.y + 4.0 * flat2 * curvature * rise));
  vec2 away = d.xz * along;
  vec2 wind = gardner.high_wind.xy;
  vec2 turned = vec2(dot(away, wind), dot(away, vec2(-wind.y, wind.x)));
  vec2 at = gardner.high.xy + turned * gardner.high.z * vec2(1.0 / gardner.high_wind.z, 1.0);
  // A pixel's length on the plane, which is seen at a slant.
  float slant = max((rise + along * along * flat2 * curvature) / along, 0.02);
  float footprint = along * frame.camera.w * gardner.high.z * inversesqrt(slant);
  float value = gardner_texture(vec3(at, 0.0), int(gardner.high_form.w), gardner.high_wind.w, footprint);
  float depth = gardner.high_form.z *
                (1.0 - gardner_translucency(value, gardner.high_form.x, gardner.high_form.y));
  float transmittance = exp(-depth / slant);

  vec3 toward = gardner.light_direction.xyz;
  float angle = dot(d, toward);
  vec3 up = normalize(vec3(away.x, kPlanetRadius * 1.0e3, away.y));
  float cosine = dot(toward, up);
  float steep = max(abs(cosine), 0.05);
  CloudField field = cloud_field(0.5 * depth / steep, depth / steep, steep, kIceG);
  float side = cosine < 0.0 ? -1.0 : 1.0;  // a sun that has set lights it from below
  vec3 light = gardner.light_source.rgb * light_aloft(gardner.high.w, away, toward);
  vec3 source = light * cloud_source(field, ice_phase(angle), angle, side * slant, kIceG);
  // From all sides: the upper air's sky is about as bright as ours, sea and lower clouds below.
  vec3 ambient = frame.sky_illuminance.rgb * (0.5 / kPhasePi);
  source += ambient;
  AirLight air = air_before(gardner.high.w, away, d);
  vec3 seen = source * air.transmittance + air.inscattered;
  colour = vec4(min(seen * (1.0 - transmittance) * frame.time.z, vec3(kBrightest)), transmittance);
}
