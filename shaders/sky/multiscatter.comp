// Light scattered more than once, as if alike in all directions, for a light of 1 lux above the air
// (Hillaire 2020, §5.5): the second order by integration, all later ones as a geometric series.
#include "sky/air_tables.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = 0) uniform writeonly image2D table;
layout(location = 0) uniform vec3 aerosol;

// Directions lie dense at the horizon and toward the light, each with the solid angle that it stands for:
// with the sun 12 degrees down, as many even ones would miss two thirds of the light.
const int kCosines = 12, kAzimuths = 8;
const int kSteps = 12;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = imageSize(table);
  if (any(greaterThanEqual(texel, size))) return;
  Aerosol air_here = Aerosol(aerosol.x, aerosol.y, aerosol.z);
  HeightCosine place = multiscatter_place(vec2(texel) / vec2(size - 1));
  float light_cosine = place.cosine;
  float light_sine = sqrt(max(1.0 - light_cosine * light_cosine, 0.0));
  const float kIsotropic = 1.0 / (4.0 * kPhasePi);

  vec3 second = vec3(0.0);   // arriving here after one more scattering
  vec3 passed = vec3(0.0);   // share of isotropic light that is scattered toward here
  float horizon = -horizon_dip_sine(place.height);
  for (int i = 0; i < kCosines * kAzimuths; ++i) {
    float t = 1.0 - 2.0 * (float(i / kAzimuths) + 0.5) / float(kCosines);
    float side = t > 0.0 ? 1.0 - horizon : 1.0 + horizon;
    float cosine = horizon + side * t * abs(t);
    // Symmetric about the light: half the azimuths stand for all.
    float u = (float(i % kAzimuths) + 0.5) / float(kAzimuths);
    float azimuth = kPhasePi * u * u;
    float weight = 2.0 * abs(t) * side * 2.0 * u / float(kCosines * kAzimuths);
    float towards = cosine * light_cosine + sqrt(1.0 - cosine * cosine) * light_sine * cos(azimuth);
    float sea = distance_to_sea(place.height, cosine);
    float along = sea >= 0.0 ? sea : distance_to_top(place.height, cosine);
    vec3 transmittance = vec3(weight);
    for (int s = 0; s < kSteps; ++s) {
      float x0 = float(s) / float(kSteps), x1 = float(s + 1) / float(kSteps);
      float xm = 0.5 * (x0 + x1);
      float step_length = along * (x1 * x1 - x0 * x0);
      float d = along * xm * xm;
      float h = max(height_along(place.height, cosine, d), 0.0);
      float c = cosine_along(place.height, light_cosine, towards, d, h);
      Air air = air_at(air_here, h);
      vec3 step_transmittance = exp(-air.extinction * step_length);
      vec3 scattered = transmittance * (air.rayleigh + air.mie) * (vec3(1.0) - step_transmittance) /
                       air.extinction;
      second += scattered * light_transmittance(h, c) * kIsotropic;
      passed += scattered;
      transmittance *= step_transmittance;
    }
    if (sea >= 0.0) {
      float c = cosine_along(place.height, light_cosine, towards, along, 0.0);
      second += transmittance * light_transmittance(0.0, c) * max(c, 0.0) * kSeaAlbedo / kPhasePi;
    }
  }
  imageStore(table, texel, vec4(log(max(second / (vec3(1.0) - passed), vec3(1.0e-30))), 1.0));
}
