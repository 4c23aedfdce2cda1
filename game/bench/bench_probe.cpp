#include <fmt/core.h>

#include <time.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/angles.h"
#include "engine/core/paths.h"
#include "engine/graph/gl_device.h"
#include "engine/io/file.h"
#include "engine/platform/headless_context.h"
#include "engine/sky/probe_reference.h"
#include "game/bench/bench_report.h"
#include "game/bench/benches.h"
#include "game/bench/plot.h"
#include "shaders/shared/bindings.h"

namespace offing {
namespace {

constexpr int kQueries = 256, kBruteForce = 4096, kTimed = 3;

struct Case {
  int size, samples;
};

struct Measure {
  double whole_ms = 0.0;       ///< one whole refresh
  double cpu_ms = 0.0;         ///< of the thread that draws, in a frame with a slice: median
  double largest_share = 0.0;  ///< of the slices
  std::vector<double> error_of_levels;  ///< by roughness 0, 0.1 … 1
  double irradiance_error = 0.0;
};

// One moment's light, and the tables that show it.
class Stage {
 public:
  Stage() : shaders_(data_root() / "shaders"), graph_(device_), sky_(shaders_, 2) {}

  void set_sun(double elevation_deg, double azimuth_deg = 240.0) {
    CelestialState state;
    state.sun.azimuth_deg = azimuth_deg;
    state.sun.elevation_deg = state.sun.elevation_airless_deg = elevation_deg;
    state.moon.elevation_deg = state.moon.elevation_airless_deg = -50.0;
    light_ = model_.update(state, 0.1, 3.0);
    shared::FrameData frame{};
    light_.fill(frame);
    frame.camera = {0.0f, 3.0f, 0.0f, 1e-3f};
    frame.wind = {-6.0f, 0.0f, 5.0f, 8.0f};
    frame_.write(frame);
    frame_.bind_uniform(OFFING_BIND_FRAME);
  }

  Measure measure(const Case& c) {
    Measure measure;
    std::vector<double> times;
    const ProbeReference reference(shaders_);
    for (int run = 0; run < kTimed; ++run) {
      Probe probe(shaders_, {.size = c.size, .samples = c.samples});
      const std::vector<double> shares = probe.slice_shares();
      measure.largest_share = *std::max_element(shares.begin(), shares.end());
      graph_.begin_frame();
      const SkyIds sky = sky_.add_tables(graph_, light_);
      const ProbeIds ids = probe.add(graph_, light_, 8.0, sky_, sky);
      double start = 0.0;
      graph_.add(
          "ask",
          [&](PassBuilder& pass) {
            sky.read_by(pass);
            ids.read_by(pass);
            pass.side_effect();
          },
          [&](const PassContext& context) {
            glFinish();
            times.push_back(now_ms() - start);
            if (run + 1 < kTimed) return;
            for (int tenth = 0; tenth <= 10; ++tenth) {
              measure.error_of_levels.push_back(relative_rms(
                  reference.ask(context, sky_, sky, probe, ids,
                                queries_all_round(kQueries, 0.1f * static_cast<float>(tenth)),
                                tenth == 0 ? 1 : kBruteForce)));
            }
            measure.irradiance_error = relative_rms(reference.ask(
                context, sky_, sky, probe, ids, queries_all_round(kQueries, -1.0f), kBruteForce));
          });
      glFinish();
      start = now_ms();
      graph_.execute();
    }
    measure.whole_ms = *std::min_element(times.begin(), times.end());
    return measure;
  }

  /// What frames cost the thread that draws while the sun turns about the zenith, so that the
  /// probe is refreshed slice by slice and the sky's tables stand: to declare the passes, to run
  /// the graph, and what the driver does in its calls. Of Mesa's software renderer other threads do
  /// the drawing itself, and their time is not in this.
  double processor_ms(const Case& c, double elevation_deg) {
    Probe probe(shaders_, {.size = c.size, .samples = c.samples});
    std::vector<double> times;
    for (int frame = 0; frame < 3 * probe.settings().slices; ++frame) {
      set_sun(elevation_deg, 240.0 + 0.02 * frame);
      const double start = processor_now_ms();
      graph_.begin_frame();
      const SkyIds sky = sky_.add_tables(graph_, light_);
      const ProbeIds ids = probe.add(graph_, light_, 8.0, sky_, sky);
      graph_.add(
          "use",
          [&](PassBuilder& pass) {
            ids.read_by(pass);
            pass.side_effect();
          },
          [](const PassContext&) {});
      graph_.execute();
      if (frame > 0) times.push_back(processor_now_ms() - start);
      glFinish();
    }
    std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2),
                     times.end());
    return times[times.size() / 2];
  }

 private:
  static double processor_now_ms() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
  }
  static double now_ms() {
    return std::chrono::duration<double, std::milli>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
  }

  HeadlessContext context_;
  ShaderLibrary shaders_;
  GlDevice device_;
  FrameGraph graph_;
  Sky sky_;
  SkyLightModel model_;
  SkyLight light_;
  gl::Buffer frame_{"frame", sizeof(shared::FrameData)};
};

}  // namespace

// Size and samples of the probe: what a whole refresh takes, and how far from brute force it ends.
void bench_probe(const Options& options) {
  const std::vector<Case> cases = {{48, 48}, {96, 48}, {96, 64}, {128, 64}};
  Stage stage;
  nlohmann::ordered_json report;
  report["samples_of_reference"] = kBruteForce;
  report["directions"] = kQueries;
  Plot plot{.title = "Reflection probe: error of a refresh against its time",
            .x_title = "whole refresh, ms",
            .y_title = "rms error, %",
            .log_x = true,
            .log_y = true};
  for (const double elevation : {50.0, 6.0, -4.0}) {
    stage.set_sun(elevation);
    for (const int level : {0, 4, 10}) {
      plot.curves.push_back(
          {fmt::format("sun {}°, roughness {:.1f}", elevation, 0.1 * level), {}, {}});
    }
    for (const Case& c : cases) {
      Measure m = stage.measure(c);
      m.cpu_ms = stage.processor_ms(c, elevation);
      stage.set_sun(elevation);
      nlohmann::ordered_json row = {{"sun_elevation_deg", elevation},
                                    {"size", c.size},
                                    {"samples", c.samples},
                                    {"refresh_ms", m.whole_ms},
                                    {"cpu_ms", m.cpu_ms},
                                    {"largest_slice_share", m.largest_share}};
      row["rms_error_by_roughness"] = m.error_of_levels;
      row["rms_error_of_irradiance"] = m.irradiance_error;
      report["cases"].push_back(row);
      const std::size_t first = plot.curves.size() - 3;
      for (const std::size_t k : {0u, 1u, 2u}) {
        PlotCurve& curve = plot.curves[first + k];
        const std::size_t tenth = k == 0 ? 0 : k == 1 ? 4 : 10;
        curve.points.emplace_back(m.whole_ms, 100.0 * m.error_of_levels[tenth]);
        curve.labels.push_back(fmt::format("{}², {}", c.size, c.samples));
        curve.joined = false;
      }
    }
  }
  if (!options.plot.empty()) write_text(options.plot, svg_of(plot));
  deliver_report(options, report.dump(2) + "\n");
}

}  // namespace offing
