#pragma once
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/angles.h"
#include "engine/core/random.h"
#include "engine/ocean/water_surface.h"

namespace offing {

/// Linear deep-water waves: a sum of sines with the surface, slope and orbital velocity of Airy's
/// theory.
class SineSea final : public WaterSurface {
 public:
  /// One wave: amplitude and length in m, running toward `to` (rad from north, clockwise).
  SineSea(double amplitude, double length, double to) { add(amplitude, length, to, 0.0); }

  /// A wind sea from the north: Pierson-Moskowitz shape between 0.6 and 3 fp, significant height
  /// and peak period given, waves up to 35 degrees off the wind.
  SineSea(double significant_height, double peak_period, std::uint64_t seed) {
    constexpr int kWaves = 16;
    double sum = 0.0;
    std::vector<double> energy(kWaves);
    for (int i = 0; i < kWaves; ++i) {
      const double f = 0.6 + 2.4 * i / (kWaves - 1);
      energy[i] = std::pow(f, -5.0) * std::exp(-1.25 * std::pow(f, -4.0));
      sum += energy[i];
    }
    const double m0 = significant_height * significant_height / 16.0;
    for (int i = 0; i < kWaves; ++i) {
      const double w = kTau / peak_period * (0.6 + 2.4 * i / (kWaves - 1));
      const double to = kPi + 1.2 * (random_uniform(seed, 1, i) - 0.5);
      add(std::sqrt(2.0 * m0 * energy[i] / sum), kTau * kGravity / (w * w), to,
          kTau * random_uniform(seed, 2, i));
    }
  }

  void sample(std::span<const glm::dvec2> points, double time,
              std::span<WaterSample> out) const override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      double height = 0.0;
      glm::dvec2 slope(0.0);
      glm::dvec3 velocity(0.0);
      for (const Wave& wave : waves_) {
        const double phase = glm::dot(wave.k, points[i]) - wave.w * time + wave.phase;
        const double c = wave.amplitude * std::cos(phase), s = wave.amplitude * std::sin(phase);
        height += c;
        slope -= s * wave.k;
        velocity += glm::dvec3(c * wave.drift.x, wave.w * s, c * wave.drift.y);
      }
      out[i] = {height, glm::normalize(glm::dvec3(-slope.x, 1.0, -slope.y)), velocity};
    }
  }

 private:
  struct Wave {
    double amplitude, w, phase;
    glm::dvec2 k, drift;  // drift: w along k
  };
  void add(double amplitude, double length, double to, double phase) {
    const double k = kTau / length;
    const double w = std::sqrt(kGravity * k);
    const glm::dvec2 along(std::sin(to), -std::cos(to));
    waves_.push_back({amplitude, w, phase, k * along, w * along});
  }
  std::vector<Wave> waves_;
};

}  // namespace offing
