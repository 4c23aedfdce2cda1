// Cirrus and cirrostratus: a thin layer of ice drawn as Gardner's sky plane (1), (3)-(6), (9). The plane
// is bent with the earth, so that it ends behind the horizon. Drawn smaller than the screen, since nothing
// of it is sharp; composite.frag puts it over the sky.
#include "shared/frame.h"
#include "sky/sky.glsl"
#include "clouds/far_air.glsl"
#include "lib/phase_cloud.glsl"
#include "lib/cloud_scattering.glsl"
#include "lib/gardner.glsl"
#include "shared/gardner.h"

layout(binding = 0) uniform sampler2D tile;  // gardner_tile.comp; repeating, with mips
layout(location = 1) uniform vec2 cell;      // size of a pixel over the screen's
layout(location = 0) out vec4 colour;        // radiance × exposure, transmittance

// A low sun shines into streaks from the side: they are some kilometres wide and half of one thick, no endless
// layer. The least sine at which light may cross them.
const float kFlattest = 0.17;
const float kBrightest = 30000.0;  // two of them still fit a half float

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

// The texture function at a place in wavelengths; what is finer than `footprint` (in the same) is smoothed away.
float texture_at(vec2 at, float footprint) {
  return textureLod(tile, 0.5 * at, log2(max(0.5 * footprint * float(textureSize(tile, 0).x), 1.0))).r;
}

// Optical depth of the layer. Where it is dense Gardner's (9) tells, of a texture that a second look at it has
// bent; there a third, long along the wind and narrow across, draws it out into fibres. Whole multiples of the
// first one's wavelengths, so that all repeat after its period.
float layer_depth(vec2 at, float footprint) {
  const vec2 kFibres = vec2(2.0, 13.0);
  const float kBend = 0.9, kFringe = 0.30;
  at.y += kBend * (texture_at(at.yx, 0.35) - 0.3);
  float fibre = texture_at(at * kFibres + 0.7, kFibres.y * footprint);
  float fine = texture_at(at * kFibres.yx + vec2(0.2, 0.9), kFibres.y * footprint);
  float value = texture_at(at, footprint) + kFringe * (0.7 * fibre + 0.3 * fine - 0.3);
  float dense = 1.0 - gardner_translucency(value, gardner.high_form.x, gardner.high_form.y);
  return gardner.high_form.z * dense * (0.2 + 2.4 * fibre * fibre + 0.6 * fine);
}

void main() {
  vec2 corner = gl_FragCoord.xy * cell * frame.viewport.zw * 2.0 - 1.0;
  vec4 ahead = frame.relative_from_clip * vec4(corner, 1.0, 1.0);
  vec3 d = normalize(ahead.xyz / ahead.w);
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
  vec2 lengths = along * frame.camera.w * gardner.high.z * cell / vec2(1.0, slant);
  float footprint = sqrt(lengths.x * lengths.y);
  float depth = layer_depth(at, footprint);
  float transmittance = exp(-depth / slant);

  vec3 toward = gardner.light_direction.xyz;
  float angle = dot(d, toward);
  vec3 up = normalize(vec3(away.x, kPlanetRadius * 1.0e3, away.y));
  float cosine = dot(toward, up);
  float steep = max(abs(cosine), kFlattest);
  CloudField field = cloud_field(0.5 * depth / steep, depth / steep, steep, kIceG, 0.0);
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
