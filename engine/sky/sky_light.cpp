#include "engine/sky/sky_light.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <vector>

#include "engine/core/angles.h"

#define OFFING_GLSL "shaders/lib/phase.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/scattering.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/night.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

using glm::dvec3;

constexpr double kSunLux = 133.1e3;    // above the air at 1 au
constexpr double kFullMoonLux = 0.36;  // above the air at 384400 km
constexpr double kMoonDistanceKm = 384400.0;
constexpr double kCorona = 1.0e-6;  // of full sunlight
/// What the air outside the moon's shadow, some tens of kilometres off, sends into it: luminance of
/// the zenith and of the band round the horizon over the level illuminance that the sky would have
/// without the moon (some lux in all by day, as measured in totalities).
constexpr double kUmbraZenith = 3.0e-5, kUmbraHorizon = 1.8e-3;
/// Airglow, zodiacal light and stars too faint for the catalogue at the zenith of a dark
/// place: 21.7 mag per square second.
constexpr double kNightLuminance = 2.4e-4;
constexpr double kLowestLight = -20.0, kNodeStep = 1.0;  // degrees of elevation of a light
constexpr int kNodes = static_cast<int>((90.0 - kLowestLight) / kNodeStep) + 4;

double luminance(const dvec3& c) { return glm::dot(c, dvec3(0.2126, 0.7152, 0.0722)); }

/// Of luminance 1, as is moon_colour(): sunlight is the white of sRGB here.
const dvec3 kNightColour = dvec3(0.86, 1.02, 1.0) / luminance(dvec3(0.86, 1.02, 1.0));

/// Of luminance 1: blue that has been scattered twice, and the red of light from far through the
/// air.
const dvec3 kUmbraBlue = dvec3(0.62, 0.95, 1.75) / luminance(dvec3(0.62, 0.95, 1.75));
const dvec3 kUmbraRed = dvec3(1.9, 0.92, 0.38) / luminance(dvec3(1.9, 0.92, 0.38));

double smooth(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// Toward a body as if there were no air.
dvec3 airless(const SkyPosition& body) {
  SkyPosition p = body;
  p.elevation_deg = body.elevation_airless_deg;
  return p.direction();
}

/// Height over width of its disc: how much less refraction lifts the upper limb.
double flattening(const SkyPosition& body) {
  const double e = body.elevation_airless_deg, r = body.radius_deg;
  return 1.0 + (refraction_deg(e + r) - refraction_deg(e - r)) / (2.0 * r);
}

/// A small table read bilinearly between its ends. A texel is computed when it is first asked for:
/// one elevation of a light needs a small part of them.
struct Table {
  int width, height;
  std::vector<dvec3> values{};  ///< NaN: not yet known

  Table(int w, int h)
      : width(w),
        height(h),
        values(static_cast<std::size_t>(w * h), dvec3(std::numeric_limits<double>::quiet_NaN())) {}

  /// `compute` gives the texel at (x, y) of 0 to 1.
  template <class F>
  dvec3 read(glsl::vec2 unit, const F& compute) {
    const double x = unit.x * (width - 1), y = unit.y * (height - 1);
    const int i = std::clamp(static_cast<int>(x), 0, width - 2);
    const int j = std::clamp(static_cast<int>(y), 0, height - 2);
    const auto value = [&](int a, int b) -> const dvec3& {
      dvec3& texel = values[static_cast<std::size_t>(b * width + a)];
      if (std::isnan(texel.x)) texel = compute(glsl::vec2(a / (width - 1.0), b / (height - 1.0)));
      return texel;
    };
    const double u = x - i, v = y - j;
    return (1 - v) * ((1 - u) * value(i, j) + u * value(i + 1, j)) +
           v * ((1 - u) * value(i, j + 1) + u * value(i + 1, j + 1));
  }
};

}  // namespace

/// All that a state of the air (haze and the observer's height) decides.
struct SkyLightModel::Air {
  double haze, height_km;
  glsl::Aerosol aerosol;
  Table transmittance_table{64, 32};
  Table multiscatter_table{48, 12};  ///< logarithms: it falls by decades below the horizon
  double night_transmittance = 0.0;  ///< share of an even sky's light that reaches a level surface
  dvec3 night_illuminance{0.0};
  std::array<dvec3, kNodes>
      sky_nodes;  ///< log illuminance for a light of 1 lux; NaN: not yet known

  Air(double haze_now, double height);
  dvec3 transmittance(double height, double cosine);
  dvec3 light(double height, double cosine);
  dvec3 multiscatter(double height, double cosine);
  dvec3 multiscatter_texel(const glsl::HeightCosine& place);
  dvec3 sky_of(double light_elevation_deg);
  dvec3 sky_illuminance(double light_elevation_deg);
  dvec3 direct(double elevation, double radius) const;
};

SkyLightModel::Air::Air(double haze_now, double height)
    : haze(haze_now), height_km(height), aerosol(glsl::aerosol_of_haze(haze_now)) {
  constexpr int kRings = 32;
  for (int i = 0; i < kRings; ++i) {
    const double cosine = (i + 0.5) / kRings;
    const double glow = luminance(transmittance(height_km, cosine));
    const double weight = kTau * cosine / kRings;
    night_illuminance += kNightLuminance * kNightColour *
                         ((glow * glsl::van_rhijn(cosine) + 0.8 * (1.0 - glow)) * weight);
    night_transmittance += (glow + 0.8 * (1.0 - glow)) * weight / kPi;
  }
  sky_nodes.fill(dvec3(std::numeric_limits<double>::quiet_NaN()));
}

dvec3 SkyLightModel::Air::transmittance(double height, double cosine) {
  constexpr int kSteps = 32;
  return transmittance_table.read(
      glsl::transmittance_units(height, cosine), [this](glsl::vec2 unit) {
        const glsl::HeightCosine place = glsl::transmittance_place(unit);
        return glsl::transmittance_to_top(aerosol, place.height, place.cosine, kSteps);
      });
}

dvec3 SkyLightModel::Air::light(double height, double cosine) {
  constexpr double kRadius = 0.00465;
  const double lowest = -glsl::horizon_dip_sine(height);
  const double share = glsl::soft_share_above_horizon(height, cosine, kRadius);
  if (share <= 0.0) return dvec3(0.0);
  return share * transmittance(height, std::max(cosine, lowest));
}

dvec3 SkyLightModel::Air::multiscatter(double height, double cosine) {
  return glm::exp(
      multiscatter_table.read(glsl::multiscatter_units(height, cosine), [this](glsl::vec2 unit) {
        return glm::log(glm::max(multiscatter_texel(glsl::multiscatter_place(unit)), dvec3(1e-30)));
      }));
}

/// As shaders/sky/multiscatter.comp, but with directions that lie dense at the horizon and toward
/// the light, each with the solid angle that it stands for: with the sun at -12 degrees even
/// directions would miss most of what there is.
dvec3 SkyLightModel::Air::multiscatter_texel(const glsl::HeightCosine& place) {
  constexpr int kCosines = 12, kAzimuths = 8, kSteps = 12;
  const double light_sine = std::sqrt(1.0 - place.cosine * place.cosine);
  const double horizon = -glsl::horizon_dip_sine(place.height);
  dvec3 second(0.0), passed(0.0);
  for (int direction = 0; direction < kCosines * kAzimuths; ++direction) {
    const double t = 1.0 - 2.0 * (direction / kAzimuths + 0.5) / kCosines;
    const double side = t > 0.0 ? 1.0 - horizon : 1.0 + horizon;
    const double cosine = horizon + side * t * std::abs(t);
    const double u = (direction % kAzimuths + 0.5) / kAzimuths;
    const double azimuth = kPi * u * u;
    const double weight = 2.0 * std::abs(t) * side * 2.0 * u / (kCosines * kAzimuths);
    const double towards =
        cosine * place.cosine + std::sqrt(1.0 - cosine * cosine) * light_sine * std::cos(azimuth);
    const double sea = glsl::distance_to_sea(place.height, cosine);
    const double along = sea >= 0.0 ? sea : glsl::distance_to_top(place.height, cosine);
    dvec3 through(1.0);
    for (int s = 0; s < kSteps; ++s) {
      const double x0 = s / double{kSteps}, x1 = (s + 1) / double{kSteps};
      const double d = along * 0.25 * (x0 + x1) * (x0 + x1);
      const double h = std::max(glsl::height_along(place.height, cosine, d), 0.0);
      const double c = glsl::cosine_along(place.height, place.cosine, towards, d, h);
      const glsl::Air air = glsl::air_at(aerosol, h);
      const dvec3 kept = glm::exp(-air.extinction * (along * (x1 * x1 - x0 * x0)));
      const dvec3 scattered = through * (air.rayleigh + air.mie) * (1.0 - kept) / air.extinction;
      second += weight * scattered * light(h, c) / (4.0 * kPi);
      passed += weight * scattered;
      through *= kept;
    }
    if (sea >= 0.0) {
      const double c = glsl::cosine_along(place.height, place.cosine, towards, along, 0.0);
      second += weight * through * light(0.0, c) * std::max(c, 0.0) * (glsl::kSeaAlbedo / kPi);
    }
  }
  return second / (1.0 - passed);
}

/// Illuminance of a level surface by the sky, for a light of 1 lux above the air.
dvec3 SkyLightModel::Air::sky_of(double light_elevation_deg) {
  constexpr int kCosines = 16, kAzimuths = 8, kSteps = 32;
  const double light_cosine = std::sin(radians(light_elevation_deg));
  const double light_sine = std::sqrt(1.0 - light_cosine * light_cosine);
  dvec3 sum(0.0);
  for (int i = 0; i < kCosines; ++i) {
    // Dense at the horizon: late in twilight only the lowest sky is lit.
    const double x = (i + 0.5) / kCosines;
    const double cosine = x * x;
    const double weight = kTau * cosine * 2.0 * x / (kCosines * kAzimuths);
    const double along = glsl::distance_to_top(height_km, cosine);
    for (int j = 0; j < kAzimuths; ++j) {
      dvec3 radiance(0.0);
      const double azimuth = kPi * (j + 0.5) / kAzimuths;
      const double towards =
          cosine * light_cosine + std::sqrt(1.0 - cosine * cosine) * light_sine * std::cos(azimuth);
      const double rayleigh = glsl::rayleigh_phase(towards);
      const double mie = glsl::cornette_shanks(glsl::kMieG, towards);
      dvec3 through(1.0);
      for (int s = 0; s < kSteps; ++s) {
        const double x0 = s / double{kSteps}, x1 = (s + 1) / double{kSteps};
        const double d = along * 0.25 * (x0 + x1) * (x0 + x1);
        const double h = std::max(glsl::height_along(height_km, cosine, d), 0.0);
        const double c = glsl::cosine_along(height_km, light_cosine, towards, d, h);
        const glsl::Air air = glsl::air_at(aerosol, h);
        const dvec3 source = light(h, c) * (air.rayleigh * rayleigh + air.mie * mie) +
                             multiscatter(h, c) * (air.rayleigh + air.mie);
        const dvec3 kept = glm::exp(-air.extinction * (along * (x1 * x1 - x0 * x0)));
        radiance += through * source * (1.0 - kept) / air.extinction;
        through *= kept;
      }
      sum += weight * glsl::srgb_from_bands(radiance);
    }
  }
  return sum;
}

/// The same, interpolated in the logarithm: twilight falls by decades.
dvec3 SkyLightModel::Air::sky_illuminance(double light_elevation_deg) {
  if (light_elevation_deg <= kLowestLight) return dvec3(0.0);
  const double x = (light_elevation_deg - kLowestLight) / kNodeStep;
  const int first = std::clamp(static_cast<int>(x), 0, kNodes - 4);
  const double t = x - first;
  dvec3 p[4];
  for (int i = 0; i < 4; ++i) {
    dvec3& node = sky_nodes[static_cast<std::size_t>(first + i)];
    if (std::isnan(node.x)) {
      const double elevation = kLowestLight + kNodeStep * (first + i - 1);
      node = glm::log(glm::max(sky_of(elevation), dvec3(1e-30)));
    }
    p[i] = node;
  }
  const dvec3 value = p[1] + 0.5 * t *
                                 (p[2] - p[0] +
                                  t * (2.0 * p[0] - 5.0 * p[1] + 4.0 * p[2] - p[3] +
                                       t * (3.0 * (p[1] - p[2]) + p[3] - p[0])));
  return glm::exp(value) * smooth(kLowestLight, kLowestLight + 1.0, light_elevation_deg);
}

/// What a disc of 1 lux above the air gives a surface that faces it: the mean over the part of it
/// that stands above the horizon, times that part.
dvec3 SkyLightModel::Air::direct(double elevation, double radius) const {
  constexpr int kSteps = 40, kStrips = 8;
  const double dip = std::asin(glsl::horizon_dip_sine(height_km));
  if (elevation > radians(5.0)) {
    return glsl::srgb_from_bands(
        glsl::transmittance_to_top(aerosol, height_km, std::sin(elevation), kSteps));
  }
  const double low = std::max(-1.0, -(elevation + dip) / radius);
  if (low >= 1.0) return dvec3(0.0);
  // Strips of the disc, level with the horizon, from its lowest visible one to its top. x = sin(a)
  // makes the chords smooth at both ends.
  const double first = std::asin(low), range = kPi / 2.0 - first;
  dvec3 sum(0.0);
  for (int i = 0; i < kStrips; ++i) {
    const double a = first + range * (i + 0.5) / kStrips;
    const double chord = std::cos(a) * std::cos(a) * range / kStrips;
    const double e = elevation + radius * std::sin(a);
    sum += chord * glsl::srgb_from_bands(
                       glsl::transmittance_to_top(aerosol, height_km, std::sin(e), kSteps));
  }
  return sum * (2.0 / kPi);
}

SkyLightModel::SkyLightModel(Starlight starlight) : starlight_(starlight) {}
SkyLightModel::~SkyLightModel() = default;
SkyLightModel::SkyLightModel(SkyLightModel&&) noexcept = default;
SkyLightModel& SkyLightModel::operator=(SkyLightModel&&) noexcept = default;

const SkyLight& SkyLightModel::update(const CelestialState& celestial, double haze,
                                      double camera_height, double exposure_ev) {
  // From the sea to a mast's top the air is the same; only far above does it matter.
  const double height_km = std::round(std::clamp(camera_height, 0.0, 20000.0) / 50.0) * 0.05;
  renew_air(haze, height_km, celestial);
  SkyLight& l = light_;
  l.haze = air_->haze;  // not `haze` while its air is still worked out: all changes in one frame
  l.camera_height = std::clamp(camera_height, 0.0, 20000.0);
  l.sun_direction = celestial.sun.direction();
  l.moon_direction = celestial.moon.direction();
  l.sun_radius = radians(celestial.sun.radius_deg);
  l.moon_radius = radians(celestial.moon.radius_deg);
  l.sun_flattening = flattening(celestial.sun);
  l.moon_flattening = flattening(celestial.moon);
  l.world_from_j2000 = celestial.world_from_j2000;
  l.world_from_moon = celestial.world_from_moon;
  l.sun_from_moon = celestial.sun_from_moon;
  l.earth_shadow = celestial.earth_shadow;

  // Without refraction, which brings the two closer near the horizon but covers nothing.
  const dvec3 to_sun = airless(celestial.sun), to_moon = airless(celestial.moon);
  const double separation =
      std::atan2(glm::length(glm::cross(to_sun, to_moon)), glm::dot(to_sun, to_moon));
  l.sun_uncovered = uncovered_sun(separation, l.sun_radius, l.moon_radius);
  l.sun_source =
      dvec3(kSunLux * l.sun_uncovered / (celestial.sun_distance_au * celestial.sun_distance_au));
  const double nearer = kMoonDistanceKm / celestial.moon_distance_km;
  const double full_moon = kFullMoonLux * nearer * nearer;
  l.moon_phase = glsl::moon_phase_brightness(celestial.moon_phase_angle_deg);
  l.moon_lit_fraction = celestial.moon_lit_fraction;
  l.moon_source =
      full_moon * l.moon_phase * glsl::moon_colour() * sunlight_on_the_moon(celestial.earth_shadow);
  l.moon_luminance =
      full_moon * l.moon_phase / (kPi * l.moon_radius * l.moon_radius) /
      std::max(glsl::lommel_seeliger_phase(radians(celestial.moon_phase_angle_deg)), 1e-4);

  const double height = l.camera_height * 1e-3;
  const auto share = [&](const SkyPosition& body, double radius) {
    return glsl::share_above_horizon(height, std::sin(radians(body.elevation_deg)), radius);
  };
  l.sun_share = share(celestial.sun, l.sun_radius);
  l.moon_share = share(celestial.moon, l.moon_radius);
  l.sun_illuminance =
      l.sun_source * air_->direct(radians(celestial.sun.elevation_deg), l.sun_radius);
  l.moon_illuminance =
      l.moon_source * air_->direct(radians(celestial.moon.elevation_deg), l.moon_radius);
  l.airglow = kNightLuminance * kNightColour;
  const dvec3 up = glm::transpose(celestial.world_from_j2000) * dvec3(0.0, 1.0, 0.0);
  const dvec3 sky_of_sun = air_->sky_illuminance(celestial.sun.elevation_deg);
  const double outside = kSunLux * luminance(sky_of_sun) * (1.0 - l.sun_uncovered);
  const dvec3 umbra_zenith = kUmbraZenith * outside * kUmbraBlue;
  l.umbra_horizon = kUmbraHorizon * outside * kUmbraRed;
  l.airglow += umbra_zenith;
  l.sky_illuminance = l.sun_source * sky_of_sun +
                      l.moon_source * air_->sky_illuminance(celestial.moon.elevation_deg) +
                      air_->night_illuminance + kPi * air_->night_transmittance * umbra_zenith +
                      glsl::kUmbraBandIlluminance * l.umbra_horizon +
                      air_->night_transmittance * starlight_.illuminance(up) * milky_way_colour();
  l.extinction = glsl::air_at(air_->aerosol, 0.0).extinction * 1e-3;
  l.star_share =
      l.sun_uncovered < 0.01 ? 1.0 : 1.0 - smooth(-5.0, -3.0, celestial.sun.elevation_deg);

  l.painted = {};
  l.exposure = eye_exposure(adapting_luminance(l)) * std::exp2(exposure_ev);
  return l;
}

void SkyLightModel::renew_air(double haze, double height_km, const CelestialState& celestial) {
  const auto fits = [&](const Air& air) { return air.haze == haze && air.height_km == height_km; };
  const auto make = [haze, height_km, sun = celestial.sun.elevation_deg,
                     moon = celestial.moon.elevation_deg] {
    auto air = std::make_unique<Air>(haze, height_km);
    air->sky_illuminance(sun);  // what the next frame will ask for
    air->sky_illuminance(moon);
    return air;
  };
  if (next_air_.valid() &&
      next_air_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
    air_ = next_air_.get();
  }
  if (air_ && fits(*air_)) return;
  if (!in_background_ || !air_) {
    air_ = make();
  } else if (!next_air_.valid()) {
    next_air_ = std::async(std::launch::async, make);
  }
}

double SkyLight::level_illuminance() const {
  return luminance(sky_illuminance) + luminance(sun_illuminance) * std::max(sun_direction.y, 0.0) +
         luminance(moon_illuminance) * std::max(moon_direction.y, 0.0);
}

void SkyLight::fill(shared::FrameData& frame) const {
  const auto pack = [](const dvec3& v, double w) {
    return glm::vec4(glm::vec3(v), static_cast<float>(w));
  };
  frame.sun_direction = pack(sun_direction, std::cos(sun_radius));
  frame.sun_illuminance = pack(sun_illuminance, sun_share);
  frame.moon_direction = pack(moon_direction, std::cos(moon_radius));
  frame.moon_illuminance = pack(moon_illuminance, moon_share);
  frame.sky_illuminance = pack(sky_illuminance, 0.0);
  // Means of what thins out upward with these scale heights, between the sea and the camera.
  const auto mean = [h = std::max(camera_height * 1e-3, 1e-6)](double scale) {
    return scale / h * -std::expm1(-h / scale);
  };
  const glsl::Aerosol aerosol = glsl::aerosol_of_haze(haze);
  const dvec3 rayleigh = glsl::rayleigh_at_sea_level();
  frame.haze = pack(
      (rayleigh * mean(glsl::kRayleighHeight) + aerosol.extinction * mean(aerosol.scale_height)) *
          1e-3,
      0.0);
  frame.time.z = static_cast<float>(exposure);
}

double adapting_luminance(const SkyLight& light) {
  constexpr double kDirectShare = 0.03;  // the eye looks at the sea and the sky, not at the sun
  const double direct = luminance(light.sun_illuminance) * std::max(light.sun_direction.y, 0.0) +
                        luminance(light.moon_illuminance) * std::max(light.moon_direction.y, 0.0);
  return (luminance(light.sky_illuminance) + kDirectShare * direct) / kPi;
}

double uncovered_sun(double separation, double sun_radius, double moon_radius) {
  if (separation >= sun_radius + moon_radius) return 1.0;
  constexpr int kRings = 64;
  double seen = 0.0, all = 0.0;
  for (int i = 0; i < kRings; ++i) {
    const double x = (i + 0.5) / kRings;
    const double ring = x * sun_radius;
    // The half angle of the ring's arc that lies within the moon (law of cosines).
    const double cosine = (ring * ring + separation * separation - moon_radius * moon_radius) /
                          std::max(2.0 * ring * separation, 1e-30);
    const double covered = std::acos(std::clamp(cosine, -1.0, 1.0)) / kPi;
    const double light = x * glsl::limb_darkening(x).y;
    seen += light * (1.0 - covered);
    all += light;
  }
  return kCorona + (1.0 - kCorona) * seen / all;
}

dvec3 sunlight_on_the_moon(const EarthShadow& shadow) {
  const double distance = glm::length(shadow.axis);
  if (distance > shadow.penumbra + 1.0) return dvec3(1.0);
  constexpr int kRings = 8, kAzimuths = 16;
  dvec3 sum(0.0);
  for (int i = 0; i < kRings; ++i) {
    const double r = std::sqrt((i + 0.5) / kRings);
    for (int j = 0; j < kAzimuths; ++j) {
      const double a = kTau * (j + 0.5) / kAzimuths;
      sum += glsl::earth_shadow(std::hypot(r * std::cos(a) - distance, r * std::sin(a)),
                                shadow.umbra, shadow.penumbra);
    }
  }
  return sum / double{kRings * kAzimuths};
}

double eye_exposure(double level_luminance) {
  // What of the picture's scale that luminance gets: bright days, evenings that darken, and nights
  // a tenth as bright as day, which the eye has got used to. A logistic curve over the decades.
  constexpr double kNightKey = 0.03, kDayKey = 0.42, kMiddle = 3.2, kSteepness = 1.6;
  const double level = std::max(level_luminance, 1e-6);
  const double key =
      kNightKey + kDayKey / (1.0 + std::exp(-kSteepness * (std::log10(level) - kMiddle)));
  return key / level;
}

}  // namespace offing
