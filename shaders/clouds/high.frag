// Cirrus and cirrostratus, a thin layer of ice, and altocumulus, droplets half as high, drawn as Gardner's sky
// planes (1), (3)-(6), (9). They are bent with the earth, so that they end behind the horizon. Drawn smaller than the screen, since nothing
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
const float kIceG = 0.76, kDropletG = 0.82;
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

// Optical depth of cirrus. Where it is dense Gardner's (9) tells, of a texture that a second look at it has
// bent; there a third, long along the wind and narrow across, draws it out into fibres. Whole multiples of the
// first one's wavelengths, so that all repeat after its period.
float cirrus_depth(vec2 at, float footprint) {
  const vec2 kFibres = vec2(2.0, 13.0);
  const float kBend = 0.9, kFringe = 0.30;
  at.y += kBend * (texture_at(at.yx, 0.35) - 0.3);
  float fibre = texture_at(at * kFibres + 0.7, kFibres.y * footprint);
  float fine = texture_at(at * kFibres.yx + vec2(0.2, 0.9), kFibres.y * footprint);
  float value = texture_at(at, footprint) + kFringe * (0.7 * fibre + 0.3 * fine - 0.3);
  float dense = 1.0 - gardner_translucency(value, gardner.high_form.x, gardner.high_form.y);
  return gardner.high_form.z * dense * (0.2 + 2.4 * fibre * fibre + 0.6 * fine);
}

// Optical depth of altocumulus: patches, as the cover asks for, of small heaps in wavering rows across the wind.
float altocumulus_depth(vec2 at, float footprint) {
  const float kHeaps = 19.0, kRow = 21.0;  // of each in a wavelength of the patches
  vec2 bend = vec2(texture_at(at.yx + 0.3, 0.1), texture_at(at * 2.0 + 0.6, 0.1)) - 0.3;
  float cover = texture_at(at + 0.35 * bend, footprint) + 0.25 * (texture_at(5.0 * at.yx, 5.0 * footprint) - 0.3);
  float within = smoothstep(0.0, 0.25, cover - gardner.middle_form.x);
  vec2 heap_at = kHeaps * at + 2.6 * bend.yx;
  float heaps = texture_at(heap_at, max(kHeaps * footprint, 0.08));
  float rows = 0.5 + 0.5 * sin(2.0 * kPhasePi * (kRow * at.x + 3.0 * bend.x + 1.5 * bend.y));
  rows = mix(0.5, rows, clamp(1.5 - 3.0 * kRow * footprint, 0.0, 1.0));
  float grown = 1.6 * heaps + 0.2 * rows + 0.3 * within - 0.5;
  return gardner.middle_form.y * within * smoothstep(0.0, 0.6, grown);
}

// Where a ray crosses a level `height` (m) over the round earth's sea.
struct SkyPlane {
  vec2 away;    // from the camera (x, z; m)
  float slant;  // sine of the ray's height there
  vec2 turned;  // `away` along and across the wind, m
  float length;  // of a pixel there, m: it is seen at a slant
};
SkyPlane sky_plane(vec3 d, float height) {
  float rise = height - frame.camera.y;
  float curvature = 0.5e-3 / kPlanetRadius;
  float flat2 = max(1.0 - d.y * d.y, 0.0);
  float along = 2.0 * rise / (d.y + sqrt(d.y * d.y + 4.0 * flat2 * curvature * rise));
  SkyPlane plane;
  plane.away = d.xz * along;
  vec2 wind = gardner.high_wind.xy;
  plane.turned = vec2(dot(plane.away, wind), dot(plane.away, vec2(-wind.y, wind.x)));
  plane.slant = max((rise + along * along * flat2 * curvature) / along, 0.02);
  plane.length = along * frame.camera.w * sqrt(cell.x * cell.y / plane.slant);
  return plane;
}

// A layer of this optical depth there, whose particles scatter with this mean cosine and phase function: light and
// transmittance.
vec4 layer_seen(vec3 d, SkyPlane plane, float height, float depth, float g, float phase) {
  vec3 toward = gardner.light_direction.xyz;
  float angle = dot(d, toward);
  vec3 up = normalize(vec3(plane.away.x, kPlanetRadius * 1.0e3, plane.away.y));
  float cosine = dot(toward, up);
  float steep = max(abs(cosine), kFlattest);
  CloudField field = cloud_field(0.5 * depth / steep, depth / steep, steep, g, 0.0);
  float side = cosine < 0.0 ? -1.0 : 1.0;  // a sun that has set lights it from below
  vec3 light = gardner.light_source.rgb * light_aloft(height, plane.away, toward);
  vec3 source = light * cloud_source(field, phase, angle, side * plane.slant, g);
  // From all sides: the upper air's sky is about as bright as ours, sea and lower clouds below.
  source += frame.sky_illuminance.rgb * (0.5 / kPhasePi);
  AirLight air = air_before(height, plane.away, d);
  vec3 seen = source * air.transmittance + air.inscattered;
  float transmittance = exp(-depth / plane.slant);
  return vec4(min(seen * (1.0 - transmittance) * frame.time.z, vec3(kBrightest)), transmittance);
}

void main() {
  vec2 corner = gl_FragCoord.xy * cell * frame.viewport.zw * 2.0 - 1.0;
  vec4 ahead = frame.relative_from_clip * vec4(corner, 1.0, 1.0);
  vec3 d = normalize(ahead.xyz / ahead.w);
  float angle = dot(d, gardner.light_direction.xyz);
  colour = vec4(0.0, 0.0, 0.0, 1.0);
  // (Loops that run once or not at all: a layer that is not there costs nothing.)
  for (int i = 0; i < int(gardner.high_form.z > 0.0); ++i) {
    float height = gardner.high.w;
    SkyPlane plane = sky_plane(d, height);
    vec2 at = gardner.high.xy + plane.turned * gardner.high.z * vec2(1.0 / gardner.high_wind.z, 1.0);
    float depth = cirrus_depth(at, plane.length * gardner.high.z);
    colour = layer_seen(d, plane, height, depth, kIceG, ice_phase(angle));
  }
  for (int i = 0; i < int(gardner.middle_form.y > 0.0); ++i) {
    float height = gardner.middle.w;
    SkyPlane plane = sky_plane(d, height);
    float depth = altocumulus_depth(gardner.middle.xy + plane.turned * gardner.middle.z, plane.length * gardner.middle.z);
    float phase = dual_henyey_greenstein(kDropletG, -0.3, 0.06, angle);
    vec4 seen = layer_seen(d, plane, height, depth, kDropletG, phase);
    colour = vec4(seen.rgb + seen.a * colour.rgb, seen.a * colour.a);
  }
}
