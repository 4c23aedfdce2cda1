#include <fmt/core.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "engine/boat/boat.h"
#include "engine/boat/floating_body.h"
#include "engine/boat/polar.h"
#include "engine/core/angles.h"
#include "engine/core/random.h"
#include "engine/io/file.h"
#include "game/bench/bench_report.h"
#include "game/bench/benches.h"
#include "game/bench/plot.h"
#include "game/render/voyage.h"

namespace offing {
namespace {

/// A wind sea as a sum of Airy waves in double precision: the same for every step.
class WaveSum final : public WaterSurface {
 public:
  WaveSum(double significant_height, double peak_period, std::uint64_t seed) {
    constexpr int kWaves = 16;
    double sum = 0.0;
    for (int i = 0; i < kWaves; ++i) {
      const double f = 0.6 + 2.4 * i / (kWaves - 1);  // of the peak; Pierson-Moskowitz's shape
      const double w = kTau / peak_period * f, k = w * w / kGravity;
      const double to = kPi + 1.2 * (random_uniform(seed, 1, i) - 0.5);
      const glm::dvec2 along(std::sin(to), -std::cos(to));
      const double energy = std::pow(f, -5.0) * std::exp(-1.25 * std::pow(f, -4.0));
      sum += energy;
      waves_.push_back({std::sqrt(energy), w, kTau * random_uniform(seed, 2, i), k * along, along});
    }
    const double scale = significant_height * std::sqrt(2.0 / (16.0 * sum));
    for (Wave& wave : waves_) wave.amplitude *= scale;
  }

  void sample(std::span<const glm::dvec2> points, double time,
              std::span<WaterSample> out) const override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      glm::dvec2 slope(0.0);
      WaterSample sample;
      for (const Wave& wave : waves_) {
        const double phase = glm::dot(wave.k, points[i]) - wave.w * time + wave.phase;
        const double c = wave.amplitude * std::cos(phase), s = wave.amplitude * std::sin(phase);
        sample.height += c;
        slope -= s * wave.k;
        sample.velocity += wave.w * glm::dvec3(c * wave.along.x, s, c * wave.along.y);
      }
      sample.normal = glm::normalize(glm::dvec3(-slope.x, 1.0, -slope.y));
      out[i] = sample;
    }
  }

 private:
  struct Wave {
    double amplitude, w, phase;
    glm::dvec2 k, along;
  };
  std::vector<Wave> waves_;
};

struct Moment {
  glm::dvec3 place;
  double heel;
};

/// Close-reaching through a sea for kSeconds; where she was at every tenth of a second.
constexpr double kSeconds = 20.0;
std::vector<Moment> sail(const R8Parameters& parameters, const WaterSurface& sea, int rate) {
  const SteadyWind wind(7.0, 0.0);
  Boat boat(parameters);
  boat.start({0.0, 0.0}, radians(-60.0), 2.5, sea, 0.0);
  boat.hold_heading_at(radians(-60.0));
  std::vector<Moment> moments;
  const int steps = static_cast<int>(kSeconds * rate), stride = rate / 10;
  for (int i = 0; i < steps; ++i) {
    boat.step(sea, wind, static_cast<double>(i) / rate, 1.0 / rate);
    if ((i + 1) % stride == 0) moments.push_back({boat.state().position, boat.navigation().heel});
  }
  return moments;
}

/// Median time of a call in microseconds.
template <class Call>
double microseconds(int rounds, Call call) {
  std::vector<double> times;
  for (int round = 0; round < rounds; ++round) {
    const auto begin = std::chrono::steady_clock::now();
    call();
    const std::chrono::duration<double, std::micro> spent =
        std::chrono::steady_clock::now() - begin;
    times.push_back(spent.count());
  }
  std::nth_element(times.begin(), times.begin() + rounds / 2, times.end());
  return times[static_cast<std::size_t>(rounds / 2)];
}

double barrels(int count, const WaterSurface& water, double time) {
  constexpr double kStep = 1.0 / 120.0;
  std::vector<FloatingBody> bodies;
  for (int i = 0; i < count; ++i) {
    bodies.emplace_back(barrel());
    bodies.back().start({3.0 * (i % 10), 3.0 * (i / 10)}, 0.1 * i, water, time);
  }
  return microseconds(101, [&] {
    for (FloatingBody& body : bodies) body.step(water, time, kStep);
  });
}

/// The steady boat beside what two independent velocity predictions of R8 say, knots.
Plot polar_plot(const R8Parameters& parameters) {
  Plot plot{.title = "Steady speed with automatic trim; marks: two independent predictions",
            .x_title = "true wind angle, degrees",
            .y_title = "knots"};
  const struct {
    double tws, speed[5];
  } reference[] = {{6, {4.1, 4.8, 5.0, 4.0, 2.9}},
                   {12, {5.9, 6.4, 6.7, 6.1, 5.3}},
                   {20, {6.3, 6.9, 8.2, 7.6, 7.0}}};
  const double angles[] = {45, 60, 90, 120, 150};
  for (const auto& row : reference) {
    PlotCurve curve{fmt::format("{} kn", row.tws), {}}, marks{"", {}};
    marks.joined = false;
    for (double twa = 30.0; twa <= 170.0; twa += 10.0) {
      const SteadySailing s =
          sail_steadily(parameters, metres_per_second(row.tws), radians(twa), 120.0, 1.0 / 60.0);
      curve.points.push_back({twa, knots(s.speed)});
    }
    for (int i = 0; i < 5; ++i) marks.points.push_back({angles[i], row.speed[i]});
    plot.curves.push_back(curve);
    plot.curves.push_back(marks);
  }
  return plot;
}

Plot righting_plot(const R8Parameters& parameters) {
  Plot plot{.title = "Righting arm, crew amidships",
            .x_title = "heel, degrees",
            .y_title = "m",
            .curves = {{"GZ", {}}}};
  for (int heel = 0; heel <= 180; heel += 5) {
    plot.curves[0].points.push_back(
        {static_cast<double>(heel), righting_arm(parameters, radians(heel))});
  }
  return plot;
}

/// Let go in calm water, sails down, crew amidships: each motion over its first displacement.
Plot decay_plot(const R8Parameters& parameters) {
  Plot plot{.title = "Let go: 8 cm up, 8 degrees over, 2 degrees by the bow",
            .x_title = "s",
            .y_title = "share of the first displacement",
            .curves = {}};
  const CalmWater water;
  const SteadyWind no_wind(0.0, 0.0);
  const auto let_go = [&](const char* name, glm::dvec3 shift, double heel, double pitch,
                          auto read) {
    constexpr int kRate = 120;
    Boat boat(parameters);
    boat.controls().sails_up = false;
    boat.controls().crew_hikes = false;
    boat.start({0.0, 0.0}, 0.0, 0.0, water, 0.0);
    const double rest = read(boat);
    boat.displace(shift, heel, pitch);
    const double first = read(boat) - rest;
    PlotCurve curve{name, {}};
    for (int i = 0; i < 6 * kRate; ++i) {
      if (i % 6 == 0) {
        curve.points.push_back({static_cast<double>(i) / kRate, (read(boat) - rest) / first});
      }
      boat.step(water, no_wind, static_cast<double>(i) / kRate, 1.0 / kRate);
    }
    plot.curves.push_back(curve);
  };
  let_go("heave", {0.0, 0.08, 0.0}, 0.0, 0.0,
         [](const Boat& boat) { return boat.state().position.y; });
  let_go("roll", glm::dvec3(0.0), radians(8.0), 0.0,
         [](const Boat& boat) { return boat.navigation().heel; });
  let_go("pitch", glm::dvec3(0.0), 0.0, radians(2.0),
         [](const Boat& boat) { return boat.navigation().pitch; });
  return plot;
}

}  // namespace

// How far the step's length takes the boat from where a sixteen times finer one would have, and
// what a step costs on the sea that the GPU sends back.
void bench_boat(const Options& options) {
  Voyage voyage(options, {64, 36});
  const R8Parameters& parameters = voyage.world().scene().boat.parameters;
  constexpr int kRates[] = {30, 60, 120, 240, 480}, kConverged = 3840;

  std::string errors;
  std::vector<PlotCurve> by_step;
  for (const double height : {0.5, 2.0}) {
    const WaveSum sea(height, height < 1.0 ? 3.2 : 6.4, 5);
    const std::vector<Moment> truth = sail(parameters, sea, kConverged);
    PlotCurve curve{fmt::format("Hs {} m", height), {}};
    for (const int rate : kRates) {
      std::vector<Moment> moments;
      const double cost =
          microseconds(3, [&] { moments = sail(parameters, sea, rate); }) / (1e3 * kSeconds);
      double place = 0.0, heel = 0.0;
      for (std::size_t i = 0; i < moments.size(); ++i) {
        const double away = glm::distance(moments[i].place, truth[i].place);
        place += away * away / static_cast<double>(moments.size());
        const double off = moments[i].heel - truth[i].heel;
        heel += off * off / static_cast<double>(moments.size());
      }
      place = std::sqrt(place);
      heel = degrees(std::sqrt(heel));
      errors += fmt::format(
          "{}\n    {{\"hs_m\": {}, \"step_s\": {:.6f}, \"place_rms_m\": {:.3e}, \"heel_rms_deg\": "
          "{:.3e}, \"cpu_ms_per_s\": {:.4f}}}",
          errors.empty() ? "" : ",", height, 1.0 / rate, place, heel, cost);
      curve.points.push_back({1.0 / rate, place});
      curve.labels.push_back(fmt::format("1/{} s", rate));
    }
    by_step.push_back(curve);
  }

  const WaterSurface& water = voyage.renderer().water();
  const double time = voyage.world().environment().elapsed();
  const CalmWater calm;
  const EnvironmentWind wind(voyage.world().environment());
  const auto step_of_boat = [&](const WaterSurface& surface) {
    Boat boat(parameters);
    boat.start({0.0, 0.0}, 1.0, 2.0, surface, time);
    return microseconds(1001, [&] { boat.step(surface, wind, time, 1.0 / 120.0); });
  };
  std::string costs;
  PlotCurve readback{"the GPU's sea", {}}, flat{"flat water", {}};
  for (const int count : {1, 10, 100}) {
    const double sea_us = barrels(count, water, time), flat_us = barrels(count, calm, time);
    costs += fmt::format("{}\n    {{\"bodies\": {}, \"sea_us\": {:.2f}, \"flat_us\": {:.2f}}}",
                         costs.empty() ? "" : ",", count, sea_us, flat_us);
    readback.points.push_back({static_cast<double>(count), sea_us});
    flat.points.push_back({static_cast<double>(count), flat_us});
  }
  deliver_report(
      options,
      fmt::format("{{\n  \"seconds\": {}, \"converged_step_s\": {:.3e},\n  \"errors\": [{}\n  ],\n"
                  "  \"boat_step_us\": {{\"sea\": {:.2f}, \"flat\": {:.2f}}},\n"
                  "  \"barrels\": [{}\n  ]\n}}\n",
                  kSeconds, 1.0 / kConverged, errors, step_of_boat(water), step_of_boat(calm),
                  costs));
  if (options.plot.empty()) return;
  write_text(options.plot,
             svg_of({{.title = "20 s under sail: rms error of her place against the step",
                      .x_title = "step, s",
                      .y_title = "m",
                      .log_x = true,
                      .log_y = true,
                      .curves = by_step},
                     {.title = "A step of barrels, all water queries included",
                      .x_title = "bodies",
                      .y_title = "microseconds",
                      .log_x = true,
                      .log_y = true,
                      .curves = {readback, flat}},
                     polar_plot(parameters),
                     righting_plot(parameters),
                     decay_plot(parameters)}));
}

}  // namespace offing
