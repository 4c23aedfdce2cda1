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
#include "game/bench/plot.h"
#include "game/export/cloud_run.h"

namespace offing {
namespace {

using Json = nlohmann::ordered_json;

struct BenchView {
  const char* name;
  const char* scene;
  std::vector<std::string> sets;
};

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
};

constexpr const char* kNames[] = {"low", "medium", "high", "ultra"};

std::vector<Setting> settings() {
  std::vector<Setting> list;
  for (int level = 0; level < 4; ++level) {
    const CloudQuality shipped = CloudQuality::of(level);
    const auto add = [&](const char* change, double step_scale, auto with) {
      CloudQuality quality = shipped;
      with(quality);
      list.push_back({fmt::format("{}{}", kNames[level], change), quality, step_scale, !*change});
    };
    const auto same = [](CloudQuality&) {};
    add("", 1.0, same);
    add(", steps × 2", 2.0, same);
    add(", steps × 0.5", 0.5, same);
    add(", 2 light steps less", 1.0, [](CloudQuality& q) { q.light_steps -= 2; });
    add(", 2 light steps more", 1.0, [](CloudQuality& q) { q.light_steps += 2; });
    add(", twice the pixels", 1.0,
        [](CloudQuality& q) { (q.cell.x > 1 ? q.cell.x : q.cell.y) /= 2; });
    add(", half the pixels", 1.0,
        [](CloudQuality& q) { (q.cell.x > q.cell.y ? q.cell.y : q.cell.x) *= 2; });
  }
  // More than every pixel there is not.
  list.erase(std::remove_if(list.begin(), list.end(),
                            [](const Setting& s) { return s.quality.cell.y < 1; }),
             list.end());
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
constexpr int kRounds = 5;  // of timing

/// What a setting sees of one view.
class Trial {
 public:
  Trial(CloudRun& run, const Setting& setting, const FrameView& view)
      : run_(run),
        view_(view),
        frames_(std::max(2 * setting.quality.cell.x * setting.quality.cell.y, 4)) {
    view_.clouds.parameters.step_scale = setting.step_scale;
    point_.name = setting.name;
    point_.shipped = setting.shipped;
  }

  void measure_error(const Image& sky, const Image& reference) {
    stand();
    point_.still = error_of(reference, over_sky(run_.marched(view_), sky));
    pan();
    point_.pan = error_of(reference, over_sky(run_.marched(view_), sky));
  }
  void measure_time() {
    still_.push_back(stand());
    pan_.push_back(pan());
  }
  Point point() const {
    Point point = point_;
    point.still_ms = median(still_);
    point.pan_ms = median(pan_);
    return point;
  }

 private:
  static double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
  }
  /// Two rounds over the picture of a camera that stands; ms of a frame. The first frame, which
  /// marches all of it, does not count.
  double stand() {
    run_.march(turned(view_, 3.0));  // away, so that what comes is a cut
    run_.march(turned(view_, 0.0));
    double sum = 0.0;
    for (int frame = 0; frame < frames_; ++frame) {
      // The tiniest turn keeps the graph from seeing that there is nothing to do.
      sum += run_.march(turned(view_, 1e-6 * (frame % 2 + 1)));
    }
    return sum / frames_;
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
std::vector<Point> measure(const std::vector<Setting>& list,
                           const std::vector<std::unique_ptr<CloudRun>>& runs,
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
  for (const Trial& trial : trials) points.push_back(trial.point());
  return points;
}

std::vector<std::unique_ptr<CloudRun>> runs_of(const std::vector<Setting>& list) {
  std::vector<std::unique_ptr<CloudRun>> runs;
  for (const Setting& setting : list) runs.push_back(std::make_unique<CloudRun>(setting.quality));
  return runs;
}

/// The main source's march: light of its own clouds over the sky, and what it costs.
Image fixed_step(CloudRun& run, const FrameView& view, const Image& sky, double step_length,
                 int light_steps, double* ms) {
  const ShaderProgram& program = run.shaders().program({"clouds/fixed_step.comp"});
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
  return over_sky(clouds, sky);
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

/// The least time among ours that has at most this error; negative where none has.
double time_to(const std::vector<Point>& ours, ImageError Point::*when, double Point::*ms,
               double flip) {
  double best = -1.0;
  for (const Point& p : ours) {
    if ((p.*when).flip <= flip && (best < 0.0 || p.*ms < best)) best = p.*ms;
  }
  return best;
}

/// For each shipped quality: which other setting is faster and nearer to the reference at once, by
/// one measure of error. Both by more than `kMargin`: times scatter by as much.
Json beaten(const std::vector<Point>& ours, double ImageError::*error) {
  constexpr double kMargin = 0.03;
  Json result;
  for (const Point& p : ours) {
    if (!p.shipped) continue;
    const auto better = std::find_if(ours.begin(), ours.end(), [&](const Point& other) {
      return other.still_ms < (1.0 - kMargin) * p.still_ms &&
             other.still.*error < (1.0 - kMargin) * p.still.*error;
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
  without("every pixel every frame", [](CloudQuality& q) { q.cell = {1, 1}; });
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

/// Ours beside the main source's march, each against its own converged picture.
Json beside_fixed_steps(CloudRun& run, const FrameView& view, const Image& sky,
                        const std::vector<Point>& ours, PlotCurve& curve) {
  const Image converged = fixed_step(run, view, sky, 12.5, 64, nullptr);
  Json rows;
  for (const double length : {400.0, 200.0, 100.0, 50.0}) {
    double ms = 0.0;
    const Image image = fixed_step(run, view, sky, length, 8, &ms);
    const ImageError error = error_of(converged, image);
    const auto share = [&](double to) { return to < 0.0 ? Json(nullptr) : Json(to / ms); };
    rows.push_back({{"step_m", length},
                    {"light_steps", 8},
                    {"ms", ms},
                    {"flip", error.flip},
                    {"relative_rmse", error.rmse},
                    {"ours_still_share_of_time",
                     share(time_to(ours, &Point::still, &Point::still_ms, error.flip))},
                    {"ours_pan_share_of_time",
                     share(time_to(ours, &Point::pan, &Point::pan_ms, error.flip))}});
    curve.points.push_back({ms, error.flip});
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
  report["size"] = {size.x, size.y};
  report["renderer"] = gl::current_renderer().name;
  report["timer"] = software ? "cpu" : "finish";
  const std::vector<Setting> list = settings();
  const std::vector<std::unique_ptr<CloudRun>> runs = runs_of(list);
  CloudRun& truth = *runs.back();
  std::vector<Plot> plots;
  for (const BenchView& bench_view : bench_views()) {
    std::vector<std::string> sets = bench_view.sets;
    sets.insert(sets.end(), options.sets.begin(), options.sets.end());
    const FrameView view = still_view(make_scene(bench_view.scene, sets), size);

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
    const std::string name = bench_view.name;
    if (name == "day" || name == "overhead") {
      PlotCurve source{"fixed steps, full size", {}, {}};
      json["fixed_step"] = beside_fixed_steps(truth, view, sky, ours, source);
      plot.curves.push_back(source);
    }
    plots.push_back(plot);
    if (name == "day") {
      const std::vector<Setting> without = switched_off();
      for (const Point& p : measure(without, runs_of(without), view, sky, reference))
        json["switched_off"].push_back(json_of(p));
    }
    report["views"].push_back(json);
  }
  if (!options.plot.empty()) write_text(options.plot, svg_of(plots));
  deliver_report(options, report.dump(2) + "\n");
}

}  // namespace offing
