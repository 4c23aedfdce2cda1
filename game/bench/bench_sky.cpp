#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "engine/core/angles.h"
#include "engine/core/paths.h"
#include "engine/graph/gl_device.h"
#include "engine/io/file.h"
#include "engine/platform/headless_context.h"
#include "engine/sky/air_reference.h"
#include "engine/sky/sky_panorama.h"
#include "game/bench/bench_report.h"
#include "game/bench/benches.h"
#include "game/bench/plot.h"

#define OFFING_GLSL "shaders/lib/phase.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/scattering.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

constexpr int kPaths = 20000, kWarm = 5, kTimed = 11;
constexpr double kHaze = 0.0, kEye = 3.0;  // m
constexpr int kWidth = 64, kHeight = 32;   // of the panorama, read at the middles of its pixels

CelestialState sun_at(double elevation_deg) {
  CelestialState state;
  state.sun.azimuth_deg = 180.0;
  state.sun.elevation_deg = state.sun.elevation_airless_deg = elevation_deg;
  state.moon.elevation_deg = state.moon.elevation_airless_deg = -50.0;
  return state;
}

struct Place {
  int x, y;
  glm::dvec3 traced;
};

// Radiance by path tracing at some pixels of the panorama's upper half, for 1 lux above the air.
std::vector<Place> trace(const Panorama& shape, const SkyLight& light) {
  const AirReference air(kHaze);
  std::vector<Place> places;
  for (int y = 1; 2 * y < shape.height; y += 3) {
    for (int x = 0; x < shape.width / 2; x += 5) {
      const glm::dvec3 d = shape.direction(x, y);
      if (glm::dot(d, light.sun_direction) > std::cos(radians(3.0))) continue;
      places.push_back(
          {x, y,
           glsl::srgb_from_bands(air.path_traced(kEye * 1e-3, d, light.sun_direction, kPaths, 1))});
    }
  }
  return places;
}

double now_ms() {
  return std::chrono::duration<double, std::milli>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace

// Table sizes and steps of the sky view: what a moving sun costs in each frame, and how far the sky
// then is from all orders of scattering by path tracing.
void bench_sky(const Options& options) {
  const std::vector<SkySettings> cases = {{40, 28, 10},  {80, 56, 12},  {80, 56, 20},
                                          {80, 56, 40},  {128, 96, 30}, {192, 108, 36},
                                          {256, 144, 48}};
  const HeadlessContext context;
  ShaderLibrary shaders(data_root() / "shaders");
  GlDevice device;
  SkyLightModel model;
  nlohmann::ordered_json report;
  report["paths_per_direction"] = kPaths;
  Plot plot{.title = "Sky view: error against all orders of scattering, and time",
            .x_title = "table for a moving sun, ms",
            .y_title = "mean error, %",
            .log_x = true,
            .log_y = true};
  for (const double elevation : {60.0, 30.0, 10.0, 2.0, -4.0}) {
    const SkyLight light = model.update(sun_at(elevation), kHaze, kEye);
    const std::vector<Place> places = trace({kWidth, kHeight, {}}, light);
    PlotCurve curve{fmt::format("sun at {}°", elevation), {}, {}, false};
    for (const SkySettings& settings : cases) {
      FrameGraph graph(device);
      Sky sky(shaders, settings);
      Panorama panorama = sky_panorama(shaders, graph, sky, light, 8.0, kWidth, kHeight);
      double sum = 0.0, square = 0.0, brightest = 0.0;
      for (const Place& place : places) {
        const glm::dvec3 seen = panorama.at(place.x, place.y) / light.sun_source;
        for (int c = 0; c < 3; ++c) {
          const double error = seen[c] - place.traced[c];
          sum += std::abs(error) / place.traced[c];
          square += error * error;
          brightest = std::max(brightest, place.traced[c]);
        }
      }
      const auto count = 3.0 * static_cast<double>(places.size());
      std::vector<double> times;
      // Some frames first for each: caches, clocks and the driver's threads have then woken up.
      for (int i = -kWarm; i < kTimed; ++i) {
        const SkyLight moved =
            model.update(sun_at(elevation + 0.01 * (i + kWarm + 1)), kHaze, kEye);
        graph.begin_frame();
        const SkyIds ids = sky.add_tables(graph, moved);
        graph.add(
            "need",
            [&](PassBuilder& pass) {
              ids.read_by(pass);
              pass.side_effect();
            },
            [](PassContext&) {});
        glFinish();
        const double start = now_ms();
        graph.execute();
        glFinish();
        if (i >= 0) times.push_back(now_ms() - start);
      }
      std::nth_element(times.begin(), times.begin() + kTimed / 2, times.end());
      const double time = times[kTimed / 2], mean = sum / count;
      const double psnr = 20.0 * std::log10(brightest / std::sqrt(square / count));
      report["cases"].push_back({{"sun_elevation_deg", elevation},
                                 {"width", settings.width},
                                 {"height", settings.height},
                                 {"steps", settings.steps},
                                 {"tables_ms", time},
                                 {"mean_relative_error", mean},
                                 {"psnr_db", psnr}});
      curve.points.emplace_back(time, 100.0 * mean);
      curve.labels.push_back(
          fmt::format("{}×{}, {}", settings.width, settings.height, settings.steps));
    }
    plot.curves.push_back(curve);
  }
  if (!options.plot.empty()) write_text(options.plot, svg_of(plot));
  deliver_report(options, report.dump(2) + "\n");
}

}  // namespace offing
