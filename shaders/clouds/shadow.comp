// What the clouds take from the light, for every ray of it: a Beer shadow map (S. Hillaire, "Physically
// Based Sky, Atmosphere and Cloud Rendering in Frostbite", SIGGRAPH 2016). A texel stands for the ray
// through its place on the level of the map's height. R: optical depth of the whole ray, G: height at
// which it enters cloud, B: mean extinction from there to where it leaves.
#include "clouds/density.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f, binding = 0) uniform writeonly image2D shadow;
layout(location = 0) uniform ivec2 rows;  // first and number of those to bring up to date
layout(location = 1) uniform vec2 middle;  // of the map from the camera (x, z; m)
layout(location = 2) uniform vec3 toward;  // the light, not flat

const int kSteps = 40;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, rows.x);
  int size = imageSize(shadow).x;
  if (texel.x >= size || texel.y >= rows.x + rows.y) return;
  vec2 plan = middle + ((vec2(texel) + 0.5) / float(size) - 0.5) / clouds.shadow.z;
  // From the top down, as the light comes.
  vec3 at = vec3(plan.x, clouds.shadow.w - clouds.eye.x - dot(plan, plan) * clouds.eye.y, plan.y);
  float up = (clouds.layer.y - clouds.shadow.w) / toward.y;
  float down = (clouds.layer.x - clouds.shadow.w) / toward.y;
  float step_length = (up - down) / float(kSteps);
  float depth = 0.0, within = 0.0, before = -1.0;
  float enters = clouds.layer.x;
  for (int i = 0; i <= kSteps; ++i) {
    vec3 p = at + toward * (up - float(i) * step_length);
    CloudPlace place = cloud_place(p);
    float inside = cloud_body(place, p, step_length * toward.y) - kCloudMeanErosion * clouds.form.z;
    float share = cloud_mean_ramp(before, inside, kCloudEdgeWidth);
    float extinction = clouds.layer.z * place.kind.extinction * cloud_filling(place.x) * share;
    // Where between the two samples the edge lies.
    float edge = inside > 0.0 ? clamp(inside / max(inside - before, 1.0e-4), 0.0, 1.0) : 0.0;
    enters = max(enters, edge > 0.0 ? cloud_altitude(p) + edge * step_length * toward.y : 0.0);
    within += share > 0.0 ? max(edge, 0.5) : 0.0;
    depth += extinction * step_length;
    before = inside;
  }
  imageStore(shadow, texel, vec4(depth, enters, depth / (max(within, 1.0) * step_length), 0.0));
}
