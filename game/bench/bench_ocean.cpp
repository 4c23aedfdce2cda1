#include <epoxy/gl.h>
#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

#include "engine/core/paths.h"
#include "engine/gl/debug.h"
#include "engine/graph/gl_device.h"
#include "engine/io/file.h"
#include "engine/ocean/sea_maps.h"
#include "engine/platform/headless_context.h"
#include "game/bench/bench_report.h"
#include "game/bench/benches.h"
#include "game/bench/plot.h"
#include "game/bench/sea_transforms.h"

namespace offing {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Taken& taken) {
  return {{"median_ms", taken.median}, {"least_ms", taken.least}, {"cpu_ms", taken.processor}};
}

// What a choice of grids costs and what it leaves out of the sea.
struct MapsRun {
  int size, cascades;
  bool half;
  Taken taken;
  double missing_height = 0.0;  ///< rms of waves that are not carried, m
  double missing_slope = 0.0;   ///< share of the mean square slope of the spectrum
  double slope_error = 0.0;     ///< rms of storage, against single precision
};

void make_maps(SeaMaps& maps, FrameGraph& graph, double time) {
  graph.begin_frame();
  const SeaIds ids = maps.add(graph, time);
  graph.add(
      "bench.reader",
      [&](PassBuilder& pass) { pass.read(ids.displacement).read(ids.slopes).side_effect(); },
      [](PassContext&) {});
  graph.execute();
}

MapsRun run_maps(ShaderLibrary& shaders, int size, int cascades, bool half, int repeats) {
  MapsRun run{.size = size, .cascades = cascades, .half = half, .taken = {}};
  const SeaSpectrum spectrum(SeaState{}, 10.0, {0.6, 0.8});
  std::vector<Cascade> sea;
  double variance = 0.0, slope = 0.0;
  for (const CascadeBand& band : choose_bands(spectrum, cascades, size)) {
    sea.push_back(make_cascade(spectrum, band, size, 1, static_cast<int>(sea.size())));
    variance += sea.back().variance;
    slope += sea.back().resolved[0].total();
  }
  run.missing_height = std::sqrt(std::max(spectrum.statistics().m0 - variance, 0.0));
  run.missing_slope = 1.0 - slope / spectrum.statistics().mean_square_slope;

  GlDevice device;
  FrameGraph graph(device);
  SeaMaps maps(shaders, cascades, size, half ? MapStorage::kHalfSlopes : MapStorage::kSingle);
  maps.set_waves(sea, 1.0);
  double time = 100.0;
  run.taken = time_of(repeats, [&] { make_maps(maps, graph, time += 1.0 / 60.0); });
  if (half) {
    SeaMaps exact(shaders, cascades, size);
    exact.set_waves(sea, 1.0);
    make_maps(exact, graph, time);
    const auto got = maps.slopes().read_floats(4), want = exact.slopes().read_floats(4);
    double sum = 0.0;
    for (std::size_t i = 0; i < got.size(); i += 4) {
      for (std::size_t c = 0; c < 2; ++c) {
        sum += std::pow(static_cast<double>(got[i + c] - want[i + c]), 2.0);
      }
    }
    run.slope_error = std::sqrt(sum * 4.0 / static_cast<double>(got.size()));
  }
  return run;
}

PlotCurve curve_of(const std::string& name, const std::vector<MapsRun>& runs,
                   double (*error)(const MapsRun&)) {
  PlotCurve curve{.name = name, .points = {}};
  for (const MapsRun& run : runs) {
    curve.points.emplace_back(run.taken.median, error(run));
    curve.labels.push_back(fmt::format("{} x {}²{}", run.cascades, run.size, run.half ? " h" : ""));
  }
  return curve;
}

}  // namespace

// Transforms side by side; maps by size, cascades and storage, time against error.
void bench_ocean(const Options& options) {
  const HeadlessContext context;
  gl::require_opengl_45();
  ShaderLibrary shaders(data_root() / "shaders");
  const int repeats = std::max(options.frames / 4, 3);
  Json json;
  json["renderer"] = gl::current_renderer().name;
  json["software"] = gl::current_renderer().software;

  Plot transforms{.title = "12 complex fields of N² points, inverse",
                  .x_title = "N",
                  .y_title = "ms, least of all runs",
                  .log_x = true,
                  .log_y = true};
  for (const int size : {64, 128, 256, 512}) {
    const auto runs = time_transforms(shaders, size, 3, size > 256 ? 3 : repeats);
    transforms.curves.resize(runs.size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const TransformRun& run = runs[i];
      Json row = {{"transform", run.name}, {"size", size}, {"complex_fields", 12}};
      row.update(json_of(run.taken));
      if (run.columns_ms > 0.0) row["columns_cpu_ms"] = run.columns_ms;
      row["gflops"] = run.gflops;
      row["snr_db"] = run.snr_db;
      row["times_ours"] = run.taken.processor / runs.front().taken.processor;
      json["transforms"].push_back(row);
      transforms.curves[i].name = run.name;
      transforms.curves[i].points.emplace_back(size, run.taken.least);
    }
  }

  std::vector<MapsRun> by_size, by_cascades, halves;
  for (const int size : {64, 128, 256, 512}) {
    by_size.push_back(run_maps(shaders, size, 3, false, size > 256 ? 3 : repeats));
    halves.push_back(run_maps(shaders, size, 3, true, size > 256 ? 3 : repeats));
  }
  for (int count = 1; count <= 5; ++count) {
    by_cascades.push_back(run_maps(shaders, 128, count, false, repeats));
  }
  for (const auto* runs : {&by_size, &halves, &by_cascades}) {
    for (const MapsRun& run : *runs) {
      Json row = {
          {"size", run.size}, {"cascades", run.cascades}, {"slopes", run.half ? "half" : "single"}};
      row.update(json_of(run.taken));
      row["missing_height_rms_m"] = run.missing_height;
      row["missing_slope_share"] = run.missing_slope;
      if (run.half) row["slope_error_rms"] = run.slope_error;
      json["maps"].push_back(row);
    }
  }
  if (!options.plot.empty()) {
    const auto height = [](const MapsRun& run) { return run.missing_height; };
    const auto slope = [](const MapsRun& run) { return run.missing_slope; };
    const Plot heights{.title = "Waves that no map carries (10 m/s, 200 km)",
                       .x_title = "ms for the maps of a frame, median",
                       .y_title = "m rms",
                       .log_x = true,
                       .log_y = true,
                       .curves = {curve_of("sizes", by_size, height),
                                  curve_of("half-float slopes", halves, height),
                                  curve_of("cascades", by_cascades, height)}};
    const Plot slopes{
        .title = "Slope that no map carries",
        .x_title = "ms for the maps of a frame, median",
        .y_title = "share of the mean square slope",
        .log_x = true,
        .curves = {curve_of("sizes", by_size, slope), curve_of("cascades", by_cascades, slope)}};
    write_text(options.plot, svg_of(std::vector<Plot>{transforms, heights, slopes}));
  }
  deliver_report(options, json.dump(2) + "\n");
}

}  // namespace offing
