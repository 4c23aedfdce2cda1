// The picture so far, with what is under water (a hull, a keel) lit as it is there: in the sun that the
// waves gather on it and in daylight that fades with depth. Things have been lit as in the air; what
// matters is the ratio of the light on a surface of this normal, by linear sRGB.
#include "shared/frame.h"
#include "sky/sky.glsl"
#include "sky/probe.glsl"
#include "ocean/underwater.glsl"

layout(binding = 3) uniform sampler2D sea_below;  // see underwater_split.frag
layout(binding = 4) uniform sampler2D solid;
layout(binding = 5) uniform sampler2D picture;
layout(location = 0) out vec4 relit;  // w: distance to what is solid, 0 where nothing is

vec3 place_of(ivec2 pixel) {
  float depth = texelFetch(solid, pixel, 0).r;
  vec4 p = frame.relative_from_clip *
           vec4((vec2(pixel) + 0.5) * frame.viewport.zw * 2.0 - 1.0, max(depth, 1.0e-7), 1.0);
  return p.xyz / p.w;
}

// Toward the neighbour that lies nearer in depth: over an edge the other one is another thing.
vec3 step_along(ivec2 pixel, ivec2 by, vec3 here) {
  vec3 before = here - place_of(max(pixel - by, ivec2(0)));
  vec3 after = place_of(min(pixel + by, ivec2(frame.viewport.xy) - 1)) - here;
  bool take = dot(after, after) > 0.0 && (dot(after, after) < dot(before, before) ||
                                          dot(before, before) <= 0.0);
  return take ? after : before;
}

// As boat/light.glsl has it.
vec3 lit_above(vec3 normal) {
  return probe_irradiance(normal) + bright_light() * max(dot(normal, water.above.xyz), 0.0);
}

vec3 lit_below(vec3 normal, vec3 relative, float depth) {
  Daylight day = daylight();
  vec3 whole = (day.direct + day.diffuse) * exp(-water.diffuse.rgb * depth);
  vec3 beam = day.direct * exp(-water.diffuse.rgb * depth) * unscattered(depth);
  vec3 scattered = whole - beam;
  // Scattered light comes from above, some from all round, the least from the depths (after the
  // radiance that Tyler measured, 1960).
  float up = 0.5 + 0.5 * normal.y;
  vec3 deep = water.glow.rgb * kWaterPi;
  float facing = max(dot(normal, water.light.xyz), 0.0) / water.light.y;
  float gathered = caustic(relative, depth, length(relative) * frame.camera.w);
  return scattered * (up * up + 0.25 * up * (1.0 - up)) + whole * deep * (1.0 - up) +
         beam * (facing * gathered);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 seen = texelFetch(sea_below, pixel, 0);
  vec3 colour = texelFetch(picture, pixel, 0).rgb;
  vec3 relative = place_of(pixel);
  float away = texelFetch(solid, pixel, 0).r > 0.0 ? length(relative) : 0.0;
  bool under = away > 0.0 && (seen.w <= 0.0 || away < seen.w);  // no surface before it
#ifdef CROSSING
  under = under && seen.w != 0.0;  // wet
#endif
  if (under) {
    vec3 across = cross(step_along(pixel, ivec2(1, 0), relative),
                        step_along(pixel, ivec2(0, 1), relative));
    vec3 normal = across * inversesqrt(max(dot(across, across), 1.0e-20));
    normal = dot(normal, relative) > 0.0 ? -normal : normal;
    float depth = max(-(frame.camera.y + relative.y), 0.0);
    vec3 ratio = lit_below(normal, relative, depth) / max(lit_above(normal), vec3(1.0e-9));
    colour *= min(ratio, vec3(8.0));
  }
  relit = vec4(min(colour, vec3(6.0e4)), away);
}
