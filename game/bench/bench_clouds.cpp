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

/// One point of a curve.
struct Point {
  std::string name;
  bool shipped = false;
  double ms = 0.0;  ///< of a frame once the first is drawn
  ImageError still, pan;
};

constexpr double kTurn = 0.006;  // radians of a pan in a frame: 20 degrees a second
constexpr int kPanFrames = 16;

Point measure(const std::string& name, CloudRun& run, const CloudQuality& quality,
              double step_scale, const FrameView& view, const Image& sky, const Image& reference) {
  Point point;
  point.name = name;
  FrameView now = view;
  now.clouds.parameters.step_scale = step_scale;
  // Still: two rounds over the picture; the first frame, which marches all of it, does not count.
  const int turns = quality.cell.x * quality.cell.y, frames = std::max(2 * turns, 2);
  run.march(turned(now, 3.0));  // away, so that what comes is a cut
  run.march(turned(now, 0.0));
  double sum = 0.0;
  for (int frame = 0; frame < frames; ++frame) {
    // The tiniest turn keeps the graph from seeing that there is nothing to do.
    sum += run.march(turned(now, 1e-6 * (frame % 2 + 1)));
  }
  point.ms = sum / frames;
  point.still = error_of(reference, over_sky(run.marched(now), sky));
  // Panning toward the same view.
  for (int frame = kPanFrames; frame >= 0; --frame) run.march(turned(now, -kTurn * frame));
  point.pan = error_of(reference, over_sky(run.marched(now), sky));
  return point;
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
  return {{"name", p.name},
          {"shipped", p.shipped},
          {"ms", p.ms},
          {"still", {{"flip", p.still.flip}, {"relative_rmse", p.still.rmse}}},
          {"pan", {{"flip", p.pan.flip}, {"relative_rmse", p.pan.rmse}}}};
}

/// The least time among ours that has at most this error; negative where none has.
double time_to(const std::vector<Point>& ours, ImageError Point::*when, double flip) {
  double best = -1.0;
  for (const Point& p : ours) {
    if ((p.*when).flip <= flip && (best < 0.0 || p.ms < best)) best = p.ms;
  }
  return best;
}

constexpr const char* kNames[] = {"low", "medium", "high", "ultra"};

/// What each optimisation buys: the medium quality with one of them switched off.
std::vector<std::pair<std::string, CloudQuality>> switched_off() {
  const CloudQuality all = CloudQuality::of(1);
  std::vector<std::pair<std::string, CloudQuality>> list = {{"everything on", all}};
  const auto without = [&](const char* name, auto change) {
    CloudQuality q = all;
    change(q);
    list.emplace_back(name, q);
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
  std::vector<std::unique_ptr<CloudRun>> runs;  // one for each quality
  runs.reserve(4);
  for (int level = 0; level < 4; ++level)
    runs.push_back(std::make_unique<CloudRun>(CloudQuality::of(level)));
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

    std::vector<Point> ours;
    for (int level = 0; level < 4; ++level) {
      for (const double scale : {2.0, 1.0, 0.5}) {
        const std::string name =
            scale == 1.0 ? kNames[level] : fmt::format("{}, steps × {}", kNames[level], scale);
        ours.push_back(measure(name, *runs[static_cast<std::size_t>(level)],
                               CloudQuality::of(level), scale, view, sky, reference));
        ours.back().shipped = scale == 1.0;
      }
    }
    PlotCurve still{"still", {}, {}, false}, pan{"panning", {}, {}, false};
    for (const Point& p : ours) {
      json["ours"].push_back(json_of(p));
      still.points.push_back({p.ms, p.still.flip});
      still.labels.push_back(p.shipped ? p.name : "");
      pan.points.push_back({p.ms, p.pan.flip});
    }
    // Is any shipped quality beaten on both axes?
    for (const Point& p : ours) {
      if (!p.shipped) continue;
      const auto better = std::find_if(ours.begin(), ours.end(), [&](const Point& other) {
        return other.ms < 0.95 * p.ms && other.still.flip < 0.95 * p.still.flip;
      });
      json["beaten"][p.name] = better == ours.end() ? Json(nullptr) : Json(better->name);
    }

    if (std::string(bench_view.name) == "day" || std::string(bench_view.name) == "overhead") {
      const Image converged = fixed_step(truth, view, sky, 12.5, 64, nullptr);
      PlotCurve source{"fixed steps, full size", {}, {}};
      for (const double length : {400.0, 200.0, 100.0, 50.0}) {
        double ms = 0.0;
        const Image image = fixed_step(truth, view, sky, length, 8, &ms);
        const ImageError error = error_of(converged, image);
        const double to_still = time_to(ours, &Point::still, error.flip);
        const double to_pan = time_to(ours, &Point::pan, error.flip);
        json["fixed_step"].push_back(
            {{"step_m", length},
             {"light_steps", 8},
             {"ms", ms},
             {"flip", error.flip},
             {"relative_rmse", error.rmse},
             {"ours_still_share_of_time", to_still < 0.0 ? Json(nullptr) : Json(to_still / ms)},
             {"ours_pan_share_of_time", to_pan < 0.0 ? Json(nullptr) : Json(to_pan / ms)}});
        source.points.push_back({ms, error.flip});
      }
      plots.push_back({fmt::format("Clouds, {}: error against time", bench_view.name),
                       "ms a frame",
                       "HDR-FLIP",
                       true,
                       true,
                       {still, pan, source}});
    } else {
      plots.push_back({fmt::format("Clouds, {}: error against time", bench_view.name),
                       "ms a frame",
                       "HDR-FLIP",
                       true,
                       true,
                       {still, pan}});
    }
    if (std::string(bench_view.name) == "day") {
      for (const auto& [name, quality] : switched_off()) {
        CloudRun run(quality);
        json["switched_off"].push_back(
            json_of(measure(name, run, quality, 1.0, view, sky, reference)));
      }
    }
    report["views"].push_back(json);
  }
  if (!options.plot.empty()) write_text(options.plot, svg_of(plots));
  deliver_report(options, report.dump(2) + "\n");
}

}  // namespace offing
