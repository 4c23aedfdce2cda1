#include "engine/sky/air_reference.h"

#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <vector>

#include "engine/core/angles.h"
#include "engine/core/random.h"

#define OFFING_GLSL "shaders/lib/phase.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/scattering.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

using glm::dvec3;

const double kSea = glsl::kPlanetRadius;
const double kTop = glsl::kPlanetRadius + glsl::kAirTop;

double height_of(const dvec3& p) { return glm::length(p) - kSea; }

/// Distance along a ray to where it leaves a sphere about the earth's middle, or with `enters` to
/// where it meets it from outside; negative where it does not.
double to_sphere(const dvec3& p, const dvec3& d, double radius, bool enters) {
  const double b = glm::dot(p, d), c = glm::dot(p, p) - radius * radius;
  const double discriminant = b * b - c;
  if (discriminant < 0.0) return -1.0;
  return enters ? -b - std::sqrt(discriminant) : -b + std::sqrt(discriminant);
}

/// Optical depth between two points, by Simpson's rule in intervals that are short where air is
/// dense: toward the ray's lowest point.
dvec3 depth_between(const glsl::Aerosol& aerosol, const dvec3& from, const dvec3& d, double length,
                    int intervals) {
  const double lowest = std::clamp(-glm::dot(from, d), 0.0, length);
  dvec3 sum(0.0);
  const auto part = [&](double start, double end) {  // outward from `start`
    const double range = end - start;
    if (range == 0.0) return;
    for (int i = 0; i < intervals; ++i) {
      const auto at = [&](double x) {
        const dvec3 p = from + (start + range * x * x * x) * d;
        return glsl::air_at(aerosol, height_of(p)).extinction * (3.0 * x * x);
      };
      const double a = i / static_cast<double>(intervals);
      const double b = (i + 1) / static_cast<double>(intervals);
      sum += (at(a) + 4.0 * at(0.5 * (a + b)) + at(b)) * ((b - a) / 6.0 * std::abs(range));
    }
  };
  part(lowest, length);
  part(lowest, 0.0);
  return sum;
}

/// Toward the light; none where the sea is in the way. The light is a point.
dvec3 light_at(const glsl::Aerosol& aerosol, const dvec3& p, const dvec3& light, int intervals) {
  const double sea = to_sphere(p, light, kSea, true);
  if (sea > 0.0) return dvec3(0.0);
  const double length = to_sphere(p, light, kTop, false);
  return glm::exp(-depth_between(aerosol, p, light, length, intervals));
}

/// A direction at this cosine about an axis.
dvec3 turned(const dvec3& axis, double cosine, double azimuth) {
  const dvec3 helper = std::abs(axis.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
  const dvec3 right = glm::normalize(glm::cross(helper, axis));
  const dvec3 above = glm::cross(axis, right);
  const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
  return glm::normalize(cosine * axis +
                        sine * (std::cos(azimuth) * right + std::sin(azimuth) * above));
}

class Dice {
 public:
  Dice(std::uint64_t seed, std::uint64_t stream) : seed_(seed), stream_(stream) {}
  double next() { return random_uniform(seed_, stream_, index_++); }

 private:
  std::uint64_t seed_, stream_, index_ = 0;
};

/// Cosine of a Rayleigh scattering by inverting its distribution (3 / 8 (1 + c^2)).
double rayleigh_cosine(double u) {
  const double z = 2.0 * (2.0 * u - 1.0), root = std::sqrt(z * z + 1.0);
  return std::cbrt(z + root) + std::cbrt(z - root);
}

/// Cosine after Henyey and Greenstein; Cornette and Shanks' factor becomes a weight.
double greenstein_cosine(double g, double u) {
  const double s = (1.0 - g * g) / (1.0 - g + 2.0 * g * u);
  return std::clamp((1.0 + g * g - s * s) / (2.0 * g), -1.0, 1.0);
}

}  // namespace

AirReference::AirReference(double haze) : haze_(haze) {}

dvec3 AirReference::transmittance(double height_km, double cosine, int intervals) const {
  const dvec3 from(0.0, kSea + height_km, 0.0);
  const dvec3 d(std::sqrt(std::max(1.0 - cosine * cosine, 0.0)), cosine, 0.0);
  return glm::exp(-depth_between(glsl::aerosol_of_haze(haze_), from, d,
                                 to_sphere(from, d, kTop, false), intervals));
}

dvec3 AirReference::single(double height_km, const dvec3& view, const dvec3& light,
                           int steps) const {
  constexpr int kIntervals = 40;
  const glsl::Aerosol aerosol = glsl::aerosol_of_haze(haze_);
  const dvec3 eye(0.0, kSea + height_km, 0.0);
  const double sea = to_sphere(eye, view, kSea, true);
  const double length = sea > 0.0 ? sea : to_sphere(eye, view, kTop, false);
  const double cosine = glm::dot(view, light);
  dvec3 sum(0.0), depth(0.0);
  for (int i = 0; i < steps; ++i) {
    const double x0 = i / static_cast<double>(steps), x1 = (i + 1) / static_cast<double>(steps);
    const double t0 = length * x0 * x0, t1 = length * x1 * x1, t = 0.5 * (t0 + t1);
    const dvec3 p = eye + t * view;
    const glsl::Air air = glsl::air_at(aerosol, height_of(p));
    const dvec3 half_way = 0.5 * (t1 - t0) * air.extinction;
    const dvec3 scattered = air.rayleigh * glsl::rayleigh_phase(cosine) +
                            air.mie * glsl::cornette_shanks(glsl::kMieG, cosine);
    sum += glm::exp(-depth - half_way) * scattered * (t1 - t0) *
           light_at(aerosol, p, light, kIntervals);
    depth += 2.0 * half_way;
  }
  return sum;
}

namespace {

/// Optical depth of one band along the first ray, which all paths share.
struct FirstRay {
  static constexpr int kNodes = 600;
  double length = 0.0;
  bool ends_in_sea = false;
  std::vector<double> depth;

  FirstRay(const glsl::Aerosol& aerosol, const dvec3& eye, const dvec3& view, int band)
      : depth(kNodes + 1, 0.0) {
    const double sea = to_sphere(eye, view, kSea, true);
    ends_in_sea = sea > 0.0;
    length = ends_in_sea ? sea : to_sphere(eye, view, kTop, false);
    for (int i = 0; i < kNodes; ++i) {
      const double a = place(i), b = place(i + 1);
      const auto at = [&](double t) {
        return glsl::air_at(aerosol, height_of(eye + t * view)).extinction[band];
      };
      depth[static_cast<std::size_t>(i) + 1] =
          depth[static_cast<std::size_t>(i)] +
          (at(a) + 4.0 * at(0.5 * (a + b)) + at(b)) * (b - a) / 6.0;
    }
  }
  double place(int node) const {
    const double x = node / static_cast<double>(kNodes);
    return length * x * x;
  }
  /// Where this depth is reached.
  double at_depth(double wanted) const {
    const auto above = std::upper_bound(depth.begin(), depth.end(), wanted);
    const auto i = std::clamp<std::ptrdiff_t>(above - depth.begin(), 1, kNodes);
    const double a = depth[static_cast<std::size_t>(i - 1)], b = depth[static_cast<std::size_t>(i)];
    const double share = b > a ? (wanted - a) / (b - a) : 0.0;
    return place(static_cast<int>(i - 1)) +
           share * (place(static_cast<int>(i)) - place(static_cast<int>(i - 1)));
  }
};

/// The next collision by Woodcock's tracking: distance, or `length` where there is none before.
double next_collision(const glsl::Aerosol& aerosol, const dvec3& p, const dvec3& d, double length,
                      int band, Dice& dice) {
  const double lowest = std::clamp(-glm::dot(p, d), 0.0, length);
  // No air of the ray is denser than at its lowest point, but for ozone, whose most is added.
  const double most = glsl::air_at(aerosol, height_of(p + lowest * d)).extinction[band] +
                      glsl::ozone_absorption()[band];
  double t = 0.0;
  while (true) {
    t -= std::log1p(-dice.next()) / most;
    if (t >= length) return length;
    if (dice.next() * most < glsl::air_at(aerosol, height_of(p + t * d)).extinction[band]) return t;
  }
}

}  // namespace

dvec3 AirReference::path_traced(double height_km, const dvec3& view, const dvec3& light, int paths,
                                std::uint64_t seed, dvec3* error) const {
  constexpr int kIntervals = 12, kMostTurns = 100;
  const glsl::Aerosol aerosol = glsl::aerosol_of_haze(haze_);
  const dvec3 eye(0.0, kSea + height_km, 0.0);
  dvec3 mean(0.0), square(0.0);
  for (int band = 0; band < 3; ++band) {
    const FirstRay first(aerosol, eye, view, band);
    // The first turn is made to happen, with its chance as a weight: else most paths see nothing.
    const double chance = first.ends_in_sea ? 1.0 : 1.0 - std::exp(-first.depth.back());
    for (int path = 0; path < paths; ++path) {
      Dice dice(seed + static_cast<std::uint64_t>(band), static_cast<std::uint64_t>(path));
      dvec3 p = eye, d = view;
      double weight = chance, seen = 0.0;
      for (int turn = 0; turn < kMostTurns; ++turn) {
        double length = first.length, along = 0.0;
        bool ends_in_sea = first.ends_in_sea;
        if (turn == 0) {
          const double u = (path + dice.next()) / paths;  // an even share of the depth for each
          along = std::min(first.at_depth(-std::log1p(-u * chance)), length);
          if (ends_in_sea && -std::log1p(-u) >= first.depth.back()) along = length;
        } else {
          const double sea = to_sphere(p, d, kSea, true);
          ends_in_sea = sea > 0.0;
          length = ends_in_sea ? sea : to_sphere(p, d, kTop, false);
          along = next_collision(aerosol, p, d, length, band, dice);
        }
        if (along >= length && !ends_in_sea) break;
        p += d * along;
        if (along >= length) {
          const dvec3 up = glm::normalize(p);
          p = up * (kSea + 1e-6);
          weight *= glsl::kSeaAlbedo;
          seen += weight / kPi * std::max(glm::dot(up, light), 0.0) *
                  light_at(aerosol, p, light, kIntervals)[band];
          d = turned(up, std::sqrt(dice.next()), kTau * dice.next());
          continue;
        }
        const glsl::Air air = glsl::air_at(aerosol, height_of(p));
        const double scattering = air.rayleigh[band] + air.mie[band];
        weight *= scattering / air.extinction[band];
        const double rayleigh = air.rayleigh[band] / scattering;
        const double cosine = glm::dot(d, light);
        const double phase = rayleigh * glsl::rayleigh_phase(cosine) +
                             (1.0 - rayleigh) * glsl::cornette_shanks(glsl::kMieG, cosine);
        seen += weight * phase * light_at(aerosol, p, light, kIntervals)[band];
        if (weight < 0.01) {  // Russian roulette
          if (dice.next() < 0.5) break;
          weight *= 2.0;
        }
        if (dice.next() < rayleigh) {
          d = turned(d, rayleigh_cosine(dice.next()), kTau * dice.next());
        } else {
          const double c = greenstein_cosine(glsl::kMieG, dice.next());
          weight *= 1.5 * (1.0 + c * c) / (2.0 + glsl::kMieG * glsl::kMieG);
          d = turned(d, c, kTau * dice.next());
        }
      }
      mean[band] += seen / paths;
      square[band] += seen * seen / paths;
    }
  }
  if (error != nullptr) {
    *error = glm::sqrt(glm::max(square - mean * mean, dvec3(0.0)) / static_cast<double>(paths));
  }
  return mean;
}

}  // namespace offing
