#include <epoxy/gl.h>
#include <fmt/core.h>
#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

#include "engine/gl/debug.h"
#include "engine/io/file.h"
#include "engine/platform/headless_context.h"
#include "engine/post/flip.h"
#include "game/bench/bench_report.h"
#include "game/bench/benches.h"
#include "game/bench/path_traced.h"
#include "game/bench/plot.h"
#include "game/export/cloud_run.h"

namespace offing {
namespace {

using Json = nlohmann::ordered_json;

std::vector<BenchView> bench_views() {
  const auto from = [](const char* position, const char* target, std::vector<std::string> sets) {
    sets.insert(sets.end(), {"camera.mode=free", fmt::format("camera.position={}", position),
                             fmt::format("camera.target={}", target), "environment.haze=0.1",
                             "environment.clouds.high=0", "environment.paused=true"});
    return sets;
  };
  return {
      {"day", "default", from("0,4,0", "60,22,-80", {"environment.time=13:00:00"})},
      {"overhead", "default", from("0,4,0", "-60,90,40", {"environment.time=16:30:00"})},
      {"low sun", "sunset", from("0,4,0", "-100,14,-22", {})},
      {"moon", "moonlight", from("0,4,0", "20,30,90", {"environment.clouds.cover=0.4"})},
      {"inside", "default", from("0,1100,0", "80,1110,-60", {"environment.clouds.cover=0.8"})},
      {"above", "default", from("0,3600,0", "80,3575,-60", {})},
  };
}

/// The view of a camera that has turned to the right by so much.
FrameView turned(const FrameView& view, double angle) {
  FrameView result = view;
  const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), angle, glm::dvec3(0.0, 1.0, 0.0));
  result.frame.clip_from_relative = glm::mat4(glm::dmat4(view.frame.clip_from_relative) * turn);
  result.frame.relative_from_clip =
      glm::mat4(glm::inverse(glm::dmat4(view.frame.clip_from_relative) * turn));
  return result;
}

double relative_rmse(const Image& reference, const Image& image) {
  double squares = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
    const double error = static_cast<double>(image.pixels[i]) - reference.pixels[i];
    squares += error * error;
    sum += reference.pixels[i];
  }
  const auto count = static_cast<double>(reference.pixels.size());
  return std::sqrt(squares / count) / std::max(sum / count, 1e-12);
}

struct ImageError {
  double flip = 0.0, rmse = 0.0;
};

ImageError error_of(const Image& reference, const Image& image) {
  return {flip_hdr(reference, image).mean, relative_rmse(reference, image)};
}

/// One way to spend time: a shipped quality, or one of its values changed.
struct Setting {
  std::string name;
  CloudQuality quality;
  double step_scale = 1.0;
  bool shipped = false;
  bool as_before = false;  ///< differs from the setting before only in what a view can say
  int light_steps = 0;     ///< 0: the quality's own
};

using Runs = std::vector<std::shared_ptr<CloudRun>>;

constexpr const char* kNames[] = {"low", "medium", "high", "ultra"};

std::vector<Setting> settings() {
  std::vector<Setting> list;
  for (int level = 0; level < 4; ++level) {
    const CloudQuality shipped = CloudQuality::of(level);
    const std::string name = kNames[level];
    list.push_back({name, shipped, 1.0, true});
    list.push_back({name + ", steps × 2", shipped, 2.0, false, true});
    list.push_back({name + ", steps × 0.5", shipped, 0.5, false, true});
    list.push_back(
        {name + ", 2 light steps less", shipped, 1.0, false, true, shipped.light_steps - 2});
  }
  // Cheaper than anything that is shipped.
  CloudQuality smaller = CloudQuality::of(0);
  smaller.cell = {16, 8};
  smaller.light_steps = 1;
  list.push_back({"low, 16 × 8 cells, 1 light step, steps × 2", smaller, 2.0});
  return list;
}

/// One point of a curve.
struct Point {
  std::string name;
  bool shipped = false;
  double still_ms = 0.0, pan_ms = 0.0;  ///< of a frame, once the first is drawn
  ImageError still, pan;
};

constexpr double kTurn = 0.006;  // radians of a pan in a frame: 20 degrees a second
constexpr int kPanFrames = 16;
constexpr int kTimedFrames = 6;
constexpr glm::ivec2 kPlayed{640, 360};
constexpr int kRounds = 3;  // of timing

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// What a setting sees of one view.
class Trial {
 public:
  Trial(CloudRun& run, const Setting& setting, const FrameView& view)
      : run_(run),
        view_(view),
        frames_(std::max(2 * setting.quality.cell.x * setting.quality.cell.y, 4)) {
    view_.clouds.parameters.step_scale = setting.step_scale;
    view_.clouds.parameters.light_steps = setting.light_steps;
    point_.name = setting.name;
    point_.shipped = setting.shipped;
  }

  void measure_error(const Image& sky, const Image& reference) {
    stand(frames_);
    point_.still = error_of(reference, over_sky(run_.marched(view_), sky));
    pan();
    point_.pan = error_of(reference, over_sky(run_.marched(view_), sky));
  }
  void measure_time() {
    still_.push_back(stand(kTimedFrames));
    pan_.push_back(pan());
  }
  Point point() const {
    Point point = point_;
    point.still_ms = median(still_);
    point.pan_ms = median(pan_);
    return point;
  }

 private:
  /// So many frames of a camera that stands; ms of one. The first ones after a cut do not count.
  double stand(int frames) {
    run_.march(turned(view_, 3.0));  // away, so that what comes is a cut
    for (int frame = 0; frame < 5; ++frame) run_.march(turned(view_, 1e-6 * (frame % 2)));
    double sum = 0.0;
    for (int frame = 0; frame < frames; ++frame) {
      // The tiniest turn keeps the graph from seeing that there is nothing to do.
      sum += run_.march(turned(view_, 1e-6 * (frame % 2 + 1)));
    }
    return sum / frames;
  }
  /// Panning toward the same view.
  double pan() {
    run_.march(turned(view_, -kTurn * kPanFrames));
    double sum = 0.0;
    for (int frame = kPanFrames - 1; frame >= 0; --frame)
      sum += run_.march(turned(view_, -kTurn * frame));
    return sum / kPanFrames;
  }

  CloudRun& run_;
  FrameView view_;
  int frames_;
  Point point_;
  std::vector<double> still_, pan_;
};

/// The points of all settings for one view, timed by turns: a machine that slows down slows all.
std::vector<Point> measure(const std::vector<Setting>& list, const Runs& runs,
                           const FrameView& view, const Image& sky, const Image& reference) {
  std::vector<Trial> trials;
  for (std::size_t i = 0; i < list.size(); ++i) {
    trials.emplace_back(*runs[i], list[i], view);
    trials.back().measure_error(sky, reference);
  }
  for (int round = 0; round < kRounds; ++round) {
    for (Trial& trial : trials) trial.measure_time();
  }
  std::vector<Point> points;
  points.reserve(trials.size());
  for (const Trial& trial : trials) points.push_back(trial.point());
  return points;
}

/// One for each setting.
Runs runs_of(const std::vector<Setting>& list) {
  Runs runs;
  for (const Setting& setting : list) {
    runs.push_back(setting.as_before ? runs.back() : std::make_shared<CloudRun>(setting.quality));
  }
  return runs;
}

/// The main source's march: light of its own clouds, and what it costs.
CloudSightings fixed_step(CloudRun& run, const FrameView& view, double step_length, int light_steps,
                          double* ms) {
  const ShaderProgram& program =
      run.shaders().program({"clouds/fixed_step.comp"}, {{"CLOUDS_WITHOUT_STORMS", "1"}});
  const gl::Texture light("clouds fixed step",
                          {.format = GL_RGBA32F, .width = view.size.x, .height = view.size.y});
  const bool software = gl::current_renderer().software;
  run.run(view, [&](FrameGraph& graph, const CloudRun::Ids& ids) {
    graph.add(
        "clouds.fixed_step",
        [&](PassBuilder& pass) {
          ids.sky.read_by(pass);
          ids.field.read_by(pass);
          ids.shadow.read_by(pass);
          pass.side_effect();
        },
        [&](PassContext& context) {
          run.bind(context, ids);
          light.bind_image(0, GL_WRITE_ONLY);
          program.use();
          program.program().set(1, glm::vec2(step_length, light_steps));
          glFinish();
          const double begin = work_milliseconds(software);
          constexpr int kTile = 64;
          for (int y = 0; y < view.size.y; y += kTile) {
            for (int x = 0; x < view.size.x; x += kTile) {
              program.program().set(0, glm::ivec2(x, y));
              glDispatchCompute(kTile / 8, kTile / 8, 1);
              glFinish();
            }
          }
          if (ms != nullptr) *ms = work_milliseconds(software) - begin;
          glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
        });
  });
  CloudSightings clouds{view.size, {}, {}};
  const std::vector<float> values = light.read_floats(4);
  for (std::size_t i = 0; i < values.size(); i += 4)
    clouds.light.emplace_back(values[i], values[i + 1], values[i + 2], values[i + 3]);
  return clouds;
}

Json json_of(const Point& p) {
  const auto errors = [](double ms, const ImageError& error) {
    return Json{{"ms", ms}, {"flip", error.flip}, {"relative_rmse", error.rmse}};
  };
  return {{"name", p.name},
          {"shipped", p.shipped},
          {"still", errors(p.still_ms, p.still)},
          {"pan", errors(p.pan_ms, p.pan)}};
}

/// For each shipped quality: which other setting is faster and nearer to the reference at once, by
/// one measure of error, both while the camera stands and while it pans; by more than `kMargin`
/// each: times scatter by as much.
Json beaten(const std::vector<Point>& ours, double ImageError::*error) {
  constexpr double kMargin = 0.03;
  Json result;
  for (const Point& p : ours) {
    if (!p.shipped) continue;
    const auto better = std::find_if(ours.begin(), ours.end(), [&](const Point& other) {
      const auto less = [](double a, double b) { return a < (1.0 - kMargin) * b; };
      return less(other.still_ms, p.still_ms) && less(other.still.*error, p.still.*error) &&
             less(other.pan_ms, p.pan_ms) && less(other.pan.*error, p.pan.*error);
    });
    result[p.name] = better == ours.end() ? Json(nullptr) : Json(better->name);
  }
  return result;
}

/// What each optimisation buys: the medium quality with one of them switched off.
std::vector<Setting> switched_off() {
  const CloudQuality all = CloudQuality::of(1);
  std::vector<Setting> list = {{"everything on", all}};
  const auto without = [&](const char* name, auto change) {
    CloudQuality q = all;
    change(q);
    list.push_back({name, q});
  };
  without("every pixel every frame", [](CloudQuality& q) { q.cell = q.cut_cell = {1, 1}; });
  without("even steps", [](CloudQuality& q) {
    q.growth = 0.0f;
    q.finest = 120.0f;
    q.steps = 800;
  });
  without("no skipping of empty air", [](CloudQuality& q) {
    q.skipping = false;
    q.steps = 400;
  });
  without("no early end", [](CloudQuality& q) {
    q.least = 0.0f;
    q.steps = 400;
  });
  without("no shadow map (6 light steps)", [](CloudQuality& q) {
    q.shadow_map = false;
    q.light_steps = 6;
  });
  return list;
}

/// Ours beside the main source's march, each against its own converged picture. Times are those of
/// `large`, the same view at a size that is played: a small picture leaves a machine waiting.
Json beside_fixed_steps(CloudRun& run, const std::vector<Setting>& list, const Runs& runs,
                        const FrameView& view, const FrameView& large, const Image& sky,
                        const std::vector<Point>& ours) {
  struct Cost {
    Point point;  ///< errors at the size of `view`, times at that of `large`
    Trial trial;
  };
  std::vector<Cost> costs;
  for (std::size_t i = 0; i < list.size(); ++i) {
    // A step at full size costs seconds: not every one of ours, and no ultra, which is never the
    // fastest.
    const bool every_pixel = list[i].quality.cell == glm::ivec2(1);
    if ((list[i].shipped && !every_pixel) || i + 1 == list.size())
      costs.push_back({ours[i], Trial(*runs[i], list[i], large)});
  }
  struct Source {
    double length;
    std::vector<double> ms;
  };
  std::vector<Source> sources = {{400.0, {}}, {200.0, {}}, {100.0, {}}, {50.0, {}}};
  for (int round = 0; round < 3; ++round) {  // by turns, as above
    for (Cost& cost : costs) cost.trial.measure_time();
    for (Source& source : sources) {
      source.ms.push_back(0.0);
      fixed_step(run, large, source.length, 8, &source.ms.back());
    }
  }
  const Image converged = over_sky(fixed_step(run, view, 12.5, 64, nullptr), sky);
  Json rows;
  for (Source& source : sources) {
    const double ms = median(source.ms);
    const ImageError error =
        error_of(converged, over_sky(fixed_step(run, view, source.length, 8, nullptr), sky));
    Json row = {{"step_m", source.length},
                {"light_steps", 8},
                {"timed_at", {large.size.x, large.size.y}},
                {"ms", ms},
                {"flip", error.flip},
                {"relative_rmse", error.rmse}};
    for (const bool pan : {false, true}) {
      Json best = nullptr;  // the fastest of ours that is no worse
      for (const Cost& cost : costs) {
        const Point times = cost.trial.point();
        const double own = pan ? times.pan_ms : times.still_ms;
        const double flip = pan ? cost.point.pan.flip : cost.point.still.flip;
        if (flip <= error.flip && (best.is_null() || own < best["ms"]))
          best = {{"name", cost.point.name}, {"ms", own}, {"share_of_time", own / ms}};
      }
      row[pan ? "ours_panning" : "ours_still"] = best;
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

// Error against time: HDR-FLIP and the relative root of the mean squared error, both against
// 4096 steps a ray with the light marched to the end of the clouds, over the sky without discs.
void bench_clouds(const Options& options) {
  const glm::ivec2 size = options.size.value_or(glm::ivec2(128, 72));
  const HeadlessContext context;
  gl::require_opengl_45();
  const bool software = gl::current_renderer().software;
  Json report;
  report["renderer"] = gl::current_renderer().name;
  const auto compare_light = [&](CloudRun& run, const BenchView& view) {
    fmt::print(stderr, "bench clouds: {}, path traced\n", view.name);
    return path_traced(run, view, options.sets);
  };
  if (options.method == "pathtrace") {
    CloudRun run(CloudQuality::of(0));
    for (const auto& views : {bench_views(), lit_views()}) {
      for (const BenchView& view : views)
        report["views"].push_back({{"view", view.name}, {"path_traced", compare_light(run, view)}});
    }
    deliver_report(options, report.dump(2) + "\n");
    return;
  }
  report["size"] = {size.x, size.y};
  report["timer"] = software ? "cpu" : "finish";
  const std::vector<Setting> list = settings();
  const Runs runs = runs_of(list);
  CloudRun& truth = *runs.front();
  std::vector<Plot> plots;
  for (const BenchView& bench_view : bench_views()) {
    std::vector<std::string> sets = bench_view.sets;
    sets.insert(sets.end(), options.sets.begin(), options.sets.end());
    const FrameView view = still_view(make_scene(bench_view.scene, sets), size);
    fmt::print(stderr, "bench clouds: {}\n", bench_view.name);

    // What is kept of another view's light and weather has gone by then.
    for (int frame = 0; frame < 8; ++frame) truth.march(view);
    const Image sky = truth.sky(view);
    const double begin = work_milliseconds(software);
    const Image reference = over_sky(truth.reference(view), sky);
    Json json = {{"view", bench_view.name}, {"reference_ms", work_milliseconds(software) - begin}};

    const std::vector<Point> ours = measure(list, runs, view, sky, reference);
    PlotCurve shipped{"shipped, still", {}, {}}, still{"others, still", {}, {}, false},
        pan{"panning", {}, {}, false};
    for (const Point& p : ours) {
      json["ours"].push_back(json_of(p));
      PlotCurve& curve = p.shipped ? shipped : still;
      curve.points.push_back({p.still_ms, p.still.flip});
      curve.labels.push_back(p.shipped ? p.name : "");
      pan.points.push_back({p.pan_ms, p.pan.flip});
    }
    json["beaten"] = {{"flip", beaten(ours, &ImageError::flip)},
                      {"relative_rmse", beaten(ours, &ImageError::rmse)}};
    Plot plot{fmt::format("Clouds, {}: error against time", bench_view.name),
              "ms a frame",
              "HDR-FLIP",
              true,
              true,
              {shipped, still, pan}};
    if (bench_view.name == "day") {
      const FrameView large = still_view(make_scene(bench_view.scene, sets), kPlayed);
      json["fixed_step"] = beside_fixed_steps(truth, list, runs, view, large, sky, ours);
    }
    plots.push_back(plot);
    if (bench_view.name == "day") {
      const std::vector<Setting> without = switched_off();
      for (const Point& p : measure(without, runs_of(without), view, sky, reference))
        json["switched_off"].push_back(json_of(p));
    }
    json["path_traced"] = compare_light(truth, bench_view);
    report["views"].push_back(json);
  }
  for (const BenchView& view : lit_views())
    report["views"].push_back({{"view", view.name}, {"path_traced", compare_light(truth, view)}});
  if (!options.plot.empty()) write_text(options.plot, svg_of(plots));
  deliver_report(options, report.dump(2) + "\n");
}

}  // namespace offing
