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

constexpr int kQueries = 256, kBruteForce = 4096, kTimed = 3, kRounds = 4;

struct Measure {
  double whole_ms = 0.0;                ///< one whole refresh
  double cpu_ms = 0.0;                  ///< of the thread that draws, for the median slice
  double largest_slice_ms = 0.0;        ///< the dearest frame of a refresh in slices
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

  Measure measure(int size) {
    Measure measure;
    std::vector<double> times;
    const ProbeReference reference(shaders_);
    for (int run = 0; run < kTimed; ++run) {
      Probe probe(shaders_, {.size = size});
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

  /// What a frame with a slice takes while the sun turns about the zenith, so that the probe is
  /// refreshed slice by slice and the sky's tables stand; of each slice the least of some rounds,
  /// as others use the machine too. `cpu_ms` is the time of the thread that draws, in the median
  /// slice: to declare the passes, to run the graph, and what the driver does in its calls; less
  /// what the same frame takes while the sun stands. Mesa's software renderer draws on other
  /// threads, and their time is not in this.
  void measure_slices(int size, double elevation_deg, Measure& measure) {
    Probe probe(shaders_, {.size = size});
    const int slices = probe.settings().slices;
    std::vector<double> standing;
    std::vector<double> turning(static_cast<std::size_t>(slices), 1e9), whole = turning;
    for (int frame = 0; frame < kRounds * slices + 1; ++frame) {
      set_sun(elevation_deg, 240.0 + 0.01 * frame);
      const Spent spent = use(probe);
      if (frame == 0) continue;  // made whole
      const auto slice = static_cast<std::size_t>((frame - 1) % slices);
      turning[slice] = std::min(turning[slice], spent.cpu_ms);
      whole[slice] = std::min(whole[slice], spent.ms);
    }
    for (int frame = 0; frame < 3 * slices; ++frame) {
      const Spent spent = use(probe);
      if (frame >= 2 * slices) standing.push_back(spent.cpu_ms);  // nothing is under way any more
    }
    measure.cpu_ms = median(turning) - median(standing);
    measure.largest_slice_ms = *std::max_element(whole.begin(), whole.end());
  }

 private:
  struct Spent {
    double cpu_ms = 0.0, ms = 0.0;  ///< of the thread that draws; until all is drawn
  };

  /// A frame that uses the probe.
  Spent use(Probe& probe) {
    glFinish();
    const double start = processor_now_ms(), began = now_ms();
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
    const double spent = processor_now_ms() - start;
    glFinish();
    return {spent, now_ms() - began};
  }

  static double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }

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

// Size of the probe: what a whole refresh takes, and how far from brute force it ends.
void bench_probe(const Options& options) {
  const std::vector<int> sizes = {96, 128, 192, 256};
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
    for (const int size : sizes) {
      Measure m = stage.measure(size);
      stage.measure_slices(size, elevation, m);
      stage.set_sun(elevation);
      nlohmann::ordered_json row = {{"sun_elevation_deg", elevation},
                                    {"size", size},
                                    {"refresh_ms", m.whole_ms},
                                    {"cpu_ms", m.cpu_ms},
                                    {"largest_slice_ms", m.largest_slice_ms}};
      row["rms_error_by_roughness"] = m.error_of_levels;
      row["rms_error_of_irradiance"] = m.irradiance_error;
      report["cases"].push_back(row);
      const std::size_t first = plot.curves.size() - 3;
      for (const std::size_t k : {0u, 1u, 2u}) {
        PlotCurve& curve = plot.curves[first + k];
        const std::size_t tenth = k == 0 ? 0 : k == 1 ? 4 : 10;
        curve.points.emplace_back(m.whole_ms, 100.0 * m.error_of_levels[tenth]);
        curve.labels.push_back(fmt::format("{}²", size));
        curve.joined = false;
      }
    }
  }
  if (!options.plot.empty()) write_text(options.plot, svg_of(plot));
  deliver_report(options, report.dump(2) + "\n");
}

}  // namespace offing
