// The clouds with all orders of scattering: what every faster way of drawing them is measured against.
// Woodcock's delta tracking along the paths and ratio tracking toward the light (Novak, Georgiev, Hanika &
// Jarosz, "Monte Carlo Methods for Volumetric Light Transport Simulation", Eurographics 2018): no steps,
// no approximation of the light in a cloud, only noise. Sums samples of a part of the picture.
#include "shared/frame.h"
#include "clouds/march.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = 0) uniform image2D sum;            // radiance (cd/m^2); paths that met no cloud
layout(rg32f, binding = 1) uniform image2D sum_of_distance;  // m, of the paths that met one; their number
layout(location = 0) uniform ivec2 corner;                   // of the part, pixels
layout(location = 1) uniform ivec2 samples;                  // number of the first; how many

const int kMostSteps = 100000;  // of one tracked segment: a guard, never reached
// In thick cloud light is turned hundreds of times, and a lot that ended paths sooner than the cloud lets them
// out left its light to a few of great worth: means of hundreds of paths then fell short.
const int kMostTurns = 2500;
const int kTurnsBeforeRoulette = 200;
const float kSurvival = 0.998;

uint random_state = 0u;

// PCG's output function over a counter (Jarzynski & Olano 2020).
float random_share() {
  random_state = random_state * 747796405u + 2891336453u;
  uint word = ((random_state >> ((random_state >> 28) + 4u)) ^ random_state) * 277803737u;
  return float(((word >> 22) ^ word) >> 8) * (1.0 / 16777216.0);
}

// The most extinction anywhere (1/m): that of a dense cumulus, or more where it rains.
float majorant() { return clouds.layer.z * 1.4; }

#ifdef EVEN_EXTINCTION  // a layer that adding and doubling can solve too
float extinction_at(vec3 p) { return clouds.layer.z; }
#else
float extinction_at(vec3 p) { return cloud_extinction(p, 0.0); }
#endif

// Where a path from `origin` next meets a droplet; negative where it leaves the clouds.
float next_droplet(vec3 origin, vec3 direction) {
  CloudSpan span = cloud_span(origin, direction);
  float per_metre = majorant();
  float t = span.near;
  for (int i = 0; i < kMostSteps; ++i) {
    t -= log(1.0 - random_share()) / per_metre;
    if (t >= span.far) break;
    if (random_share() * per_metre < extinction_at(origin + direction * t)) return t;
  }
  return -1.0;
}

// Unbiased estimate of what the clouds let through toward the light.
float light_through(vec3 origin, vec3 direction) {
  CloudSpan span = cloud_span(origin, direction);
  float per_metre = majorant();
  float t = span.near;
  float through = 1.0;
  for (int i = 0; i < kMostSteps; ++i) {
    t -= log(1.0 - random_share()) / per_metre;
    if (t >= span.far) break;
    through *= 1.0 - extinction_at(origin + direction * t) / per_metre;
    if (through < 0.05) {
      if (random_share() < 0.75) return 0.0;
      through *= 4.0;
    }
  }
  return through;
}

// The phase function that the march has of light scattered once.
float phase_toward(float cosine) {
  float phase = dual_henyey_greenstein(clouds.phase.x, -clouds.phase.y, clouds.phase.z, cosine);
  for (int i = 0; i < int(clouds.march.y > 0.0); ++i) {
    phase = droplet_scattering_with_bows(droplet_phase(clouds.march.y), droplet_bows(clouds.march.y, 0.55), cosine);
  }
  return mix(0.25 / kPhasePi, phase, clouds.phase.w);
}

// The same with the peak straight on drawn wide, for light that meets a path which has been turned already. The
// path's ways are spread far wider than the peak by then, so their mean is as before; but a way that happened
// to point at the light was worth thousands, and the mean of hundreds of paths still hung on a few.
float soft_phase_toward(float cosine) {
  const float kSoft = 0.9;
  float lobes = dual_henyey_greenstein(min(clouds.phase.x, kSoft), -clouds.phase.y, clouds.phase.z, cosine);
  for (int i = 0; i < int(clouds.march.y > 0.0); ++i) {
    DropletPhase droplets = droplet_phase(clouds.march.y);
    droplets.g_peak = min(droplets.g_peak, kSoft);
    lobes = droplet_scattering_with_bows(droplets, droplet_bows(clouds.march.y, 0.55), cosine);
  }
  return mix(0.25 / kPhasePi, lobes, clouds.phase.w);
}

float random_henyey_greenstein(float g) {
  float u = random_share();
  float r = (1.0 - g * g) / (1.0 - g + 2.0 * g * u);
  return abs(g) < 1.0e-3 ? 2.0 * u - 1.0 : clamp((1.0 + g * g - r * r) / (2.0 * g), -1.0, 1.0);
}

struct Turn {
  float cosine;
  bool wide;  // by anything but the peak straight on
};

// A turn by droplets: peak, Draine's lobe (of Henyey's and Greenstein's turns those that it keeps), fog bow, glory.
Turn droplet_turn() {
  DropletPhase droplets = droplet_phase(clouds.march.y);
  DropletBows bows = droplet_bows(clouds.march.y, 0.55);
  float which = random_share();
  if (which < bows.glory) return Turn(max(-1.0 - bows.glory_width * log(1.0 - random_share()), -1.0), true);
  if (which < bows.glory + bows.bow) {
    float bell = sqrt(-2.0 * log(1.0 - random_share())) * cos(2.0 * kPhasePi * random_share());
    return Turn(clamp(bows.bow_cosine + bows.bow_width * bell, -1.0, 1.0), true);
  }
  if (random_share() >= droplets.lobe) return Turn(random_henyey_greenstein(droplets.g_peak), false);
  float cosine = 1.0;
  for (int i = 0; i < 64; ++i) {
    cosine = random_henyey_greenstein(droplets.g_lobe);
    if (random_share() * (1.0 + droplets.alpha) < 1.0 + droplets.alpha * cosine * cosine) break;
  }
  return Turn(cosine, true);
}

// A turn drawn from phase_toward().
Turn random_turn() {
  if (random_share() >= clouds.phase.w) return Turn(2.0 * random_share() - 1.0, true);
  if (clouds.march.y > 0.0) return droplet_turn();
  bool second = random_share() < clouds.phase.z;
  return Turn(random_henyey_greenstein(second ? -clouds.phase.y : clouds.phase.x), second || clouds.phase.x < 0.9);
}

vec3 turned(vec3 direction, float cosine) {
  float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
  float angle = 2.0 * kPhasePi * random_share();
  vec3 aside = normalize(abs(direction.y) < 0.9 ? cross(direction, vec3(0.0, 1.0, 0.0))
                                                : cross(direction, vec3(1.0, 0.0, 0.0)));
  return normalize(direction * cosine +
                   (aside * cos(angle) + cross(direction, aside) * sin(angle)) * sine);
}

vec3 light_at(vec3 p) {
  vec3 up = normalize(vec3(2.0 * p.x * clouds.eye.y, 1.0, 2.0 * p.z * clouds.eye.y));
  return cloud_light_at(1.0e-3 * max(cloud_altitude(p), 0.0), dot(clouds.light_direction.xyz, up),
                        clouds.light_source.rgb);
}

// What a path brings back that met its first droplet at p.
vec3 trace(vec3 p, vec3 direction, vec3 from_below) {
  vec3 light = vec3(0.0);
  vec3 toward = clouds.light_direction.xyz;
  bool wide = false;
  float worth = 1.0;
  for (int turn = 0; turn < kMostTurns; ++turn) {
    float cosine = dot(direction, toward);
    float phase = wide ? soft_phase_toward(cosine) : phase_toward(cosine);
    light += worth * phase * light_through(p, toward) * light_at(p);
    Turn drawn = random_turn();
    wide = wide || drawn.wide;
    direction = turned(direction, drawn.cosine);
    float t = next_droplet(p, direction);
    if (t < 0.0) {
      vec3 sky = clouds.ambient.y * sky_radiance(direction);
      return light + worth * (direction.y > 0.0 ? sky : from_below);
    }
    p += direction * t;
    if (turn >= kTurnsBeforeRoulette) {
      if (random_share() >= kSurvival) break;
      worth /= kSurvival;
    }
  }
  return light;
}

void main() {
  ivec2 pixel = corner + ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(sum)))) return;
  vec4 light = imageLoad(sum, pixel);
  vec2 distance = imageLoad(sum_of_distance, pixel).rg;
  for (int i = 0; i < samples.y; ++i) {
    random_state = uint(pixel.x) * 0x9e3779b1u ^ uint(pixel.y) * 0x85ebca77u ^
                   uint(samples.x + i) * 0xc2b2ae3du;
    random_share();
    random_state ^= random_state >> 15;
    random_share();
    vec2 at = (vec2(pixel) + vec2(random_share(), random_share())) / vec2(imageSize(sum));
    vec4 near = frame.relative_from_clip * vec4(2.0 * at - 1.0, 1.0, 1.0);
    vec3 direction = normalize(near.xyz / near.w);
    float t = next_droplet(vec3(0.0), direction);
    if (t < 0.0) {
      light.a += 1.0;
      continue;
    }
    vec3 p = direction * t;
    CloudRay ray = cloud_ray(direction, t);
    AirLight air = cloud_air(direction, t, cloud_altitude(p));
    light.rgb += trace(p, direction, ray.from_below) * clouds.light.w * air.transmittance + air.inscattered;
    distance += vec2(t, 1.0);
  }
  imageStore(sum, pixel, light);
  imageStore(sum_of_distance, pixel, vec4(distance, 0.0, 0.0));
}
