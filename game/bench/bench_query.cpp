#include <epoxy/gl.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "engine/core/paths.h"
#include "engine/core/random.h"
#include "engine/gl/debug.h"
#include "engine/graph/gl_device.h"
#include "engine/io/file.h"
#include "engine/ocean/direct_water.h"
#include "engine/ocean/ocean.h"
#include "engine/platform/headless_context.h"
#include "game/bench/bench_report.h"
#include "game/bench/benches.h"
#include "game/bench/plot.h"

namespace offing {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;
constexpr int kQueries = 4096;
constexpr int kCompared = 48;  // of them, with the direct sum

double ms_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / std::max<double>(1.0, static_cast<double>(values.size())));
}

// 4 m high: 12 m/s over 200 km and a swell of 3 m.
SeaState four_metres(int queries) {
  SeaState state;
  state.swell = {.height = 3.0, .period = 11.0, .from_deg = 280.0};
  state.queries = queries;
  return state;
}

struct Pace {
  std::string name;
  double fps;         // 0: from 20 to 240, each frame anew
  int collect_every;  // frames between looks at what has come back
};

struct QueryRun {
  std::vector<double> heights, velocities, ask, sample, ages;
};

QueryRun run_queries(ShaderLibrary& shaders, int method, const Pace& pace, int frames,
                     double* omitted) {
  GlDevice device;
  FrameGraph graph(device);
  Ocean ocean(shaders, {.cascades = 3, .size = 128});
  Environment environment;
  environment.wind.speed = 12.0;
  ocean.set_sea(four_metres(method), environment, 3);
  const auto known =
      ocean.cascades().first(static_cast<std::size_t>(ocean.settings().query_cascades));
  const DirectWater truth(known, ocean.choppiness());
  *omitted = ocean.statistics().m0;
  for (const Cascade& cascade : known) *omitted -= cascade.variance;
  double time = 5000.0;
  ocean.prime(graph, time);

  QueryRun run;
  std::vector<glm::dvec2> places(kQueries);
  std::vector<WaterSample> got(kQueries), want(kCompared);
  for (int frame = 0; frame < frames; ++frame) {
    const auto number = static_cast<std::uint64_t>(frame);
    time += 1.0 / (pace.fps > 0.0 ? pace.fps : 20.0 + 220.0 * random_uniform(1, 7, number));
    Clock::time_point begin = Clock::now();
    if (frame % pace.collect_every == 0) ocean.collect();
    graph.begin_frame();
    ocean.add_maps(graph, time);  // nobody looks: only what the queries need runs
    double asked = ms_since(begin);
    graph.execute();  // on a CPU renderer the work itself
    if (!gl::current_renderer().software) asked = ms_since(begin);
    run.ask.push_back(asked);
    for (int i = 0; i < kQueries; ++i) {
      const auto index = number * kQueries + static_cast<std::uint64_t>(i);
      places[static_cast<std::size_t>(i)] = {2000.0 * random_uniform(2, 0, index) - 1000.0,
                                             2000.0 * random_uniform(2, 1, index) - 1000.0};
    }
    begin = Clock::now();
    ocean.water().sample(places, time, got);
    run.sample.push_back(ms_since(begin));
    run.ages.push_back(ocean.water().age(time));
    truth.sample(std::span(places).first(kCompared), time, want);
    for (std::size_t i = 0; i < kCompared; ++i) {
      run.heights.push_back(std::abs(got[i].height - want[i].height));
      const glm::dvec3 miss = got[i].velocity - want[i].velocity;
      run.velocities.push_back(std::sqrt(miss.x * miss.x + miss.y * miss.y + miss.z * miss.z));
    }
    glFlush();
  }
  return run;
}

}  // namespace

// Heights for floating things against the exact sum, by method and frame rate.
void bench_query(const Options& options) {
  const HeadlessContext context;
  gl::require_opengl_45();
  ShaderLibrary shaders(data_root() / "shaders");
  Json json;
  json["renderer"] = gl::current_renderer().name;
  json["software"] = gl::current_renderer().software;
  json["queries_a_frame"] = kQueries;
  Plot plot{.title = "Water queries at Hs 4 m",
            .x_title = "ms for 4096 points, median",
            .y_title = "error of height, m rms",
            .log_x = true,
            .log_y = true};
  const Pace paces[] = {{"30", 30.0, 1},   {"60", 60.0, 1},   {"60, 3 frames late", 60.0, 3},
                        {"144", 144.0, 1}, {"240", 240.0, 1}, {"20 to 240", 0.0, 1}};
  for (const int method : {kDirectQueries, kReadbackQueries}) {
    PlotCurve curve{
        .name = method == kDirectQueries ? "direct" : "readback", .points = {}, .joined = false};
    for (const Pace& pace : paces) {
      double omitted = 0.0;
      const QueryRun run = run_queries(shaders, method, pace, options.frames, &omitted);
      json["omitted_bands_rms_m"] = std::sqrt(std::max(omitted, 0.0));
      json["runs"].push_back(Json{{"method", curve.name},
                                  {"frames_per_second", pace.name},
                                  {"height_rms_m", rms(run.heights)},
                                  {"height_p99_m", quantile(run.heights, 0.99)},
                                  {"velocity_rms_m_s", rms(run.velocities)},
                                  {"sample_ms_median", quantile(run.sample, 0.5)},
                                  {"sample_ms_p99", quantile(run.sample, 0.99)},
                                  {"ask_and_collect_ms_median", quantile(run.ask, 0.5)},
                                  {"ask_and_collect_ms_p99", quantile(run.ask, 0.99)},
                                  {"age_s_most", quantile(run.ages, 1.0)}});
      curve.points.emplace_back(quantile(run.sample, 0.5), rms(run.heights));
      curve.labels.push_back(pace.name);
    }
    plot.curves.push_back(curve);
  }
  if (!options.plot.empty()) write_text(options.plot, svg_of(plot));
  deliver_report(options, json.dump(2) + "\n");
}

}  // namespace offing
