#include "game/bench/path_traced.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace offing {
namespace {

using Json = nlohmann::ordered_json;

constexpr glm::ivec2 kSize{32, 18};
constexpr int kFiner = 2;            // rays of the model on a side of such a pixel
constexpr int kSamples = 60;         // paths a pixel
constexpr float kThick = 0.1f;       // transmittance
constexpr std::size_t kFewest = 18;  // such pixels that say something

/// What one pixel shows of a thick cloud, cd/m².
struct Pixel {
  double model = 0.0;
  double traced = 0.0;
  double apart = 0.0;  ///< of two halves of the paths
};

double luminance(const glm::vec4& light) {
  return 0.2126 * light.x + 0.7152 * light.y + 0.0722 * light.z;
}

/// The mean of kFiner × kFiner pixels.
glm::vec4 mean_of(const CloudSightings& fine, int x, int y) {
  glm::vec4 sum(0.0f);
  for (int row = kFiner * y; row < kFiner * (y + 1); ++row) {
    for (int column = kFiner * x; column < kFiner * (x + 1); ++column)
      sum += fine.light[static_cast<std::size_t>(row * fine.size.x + column)];
  }
  return sum / static_cast<float>(kFiner * kFiner);
}

std::vector<Pixel> thick_pixels(const CloudSightings& fine, const CloudSightings& half,
                                const CloudSightings& other) {
  std::vector<Pixel> pixels;
  for (int y = 0; y < kSize.y; ++y) {
    for (int x = 0; x < kSize.x; ++x) {
      const auto at = static_cast<std::size_t>(y * kSize.x + x);
      const glm::vec4 model = mean_of(fine, x, y);
      const glm::vec4 traced = 0.5f * (half.light[at] + other.light[at]);
      if (model.w >= kThick || traced.w >= kThick) continue;
      pixels.push_back({luminance(model), luminance(traced),
                        luminance(half.light[at]) - luminance(other.light[at])});
    }
  }
  return pixels;
}

/// Of the pixels from `first` to before `last`.
Json compared(const std::vector<Pixel>& pixels, std::size_t first, std::size_t last) {
  double model = 0.0, traced = 0.0, squares = 0.0;
  for (std::size_t i = first; i < last; ++i) {
    model += pixels[i].model;
    traced += pixels[i].traced;
    squares += pixels[i].apart * pixels[i].apart;
  }
  const double ratio = model / traced, count = static_cast<double>(last - first);
  // The mean of two halves is as uncertain as half their difference.
  return {{"model_cd_m2", model / count},
          {"traced_cd_m2", traced / count},
          {"ratio", ratio},
          {"noise", 0.5 * std::sqrt(squares) / traced * ratio}};
}

/// From over the open sea.
BenchView over_sea(const char* name, const char* time, double azimuth, double elevation,
                   std::vector<std::string> sets = {}) {
  const double a = azimuth * M_PI / 180.0, e = elevation * M_PI / 180.0;
  const std::string target = fmt::format("{:.4f},{:.4f},{:.4f}", 900.0 + 1e3 * cos(e) * sin(a),
                                         3.0 + 1e3 * sin(e), 900.0 - 1e3 * cos(e) * cos(a));
  std::vector<std::string> all = {fmt::format("environment.time={}", time), "camera.mode=free",
                                  "camera.position=900,3,900", "camera.target=" + target,
                                  "camera.fov=60"};
  all.insert(all.end(), sets.begin(), sets.end());
  return {name, "default", all};
}

}  // namespace

std::vector<BenchView> lit_views() {
  const std::vector<std::string>
      stratus = {"environment.clouds.cover=0.7", "environment.clouds.type=0"},
      rolls = {"environment.clouds.cover=0.6", "environment.clouds.type=0.5"},
      closed = {"environment.clouds.cover=1", "environment.clouds.type=0.5"},
      storm = {"environment.clouds.cover=0.5", "environment.clouds.precipitation=0.8",
               "camera.position=-4000,3,-2000", "camera.target=-3134,200,-1500"};
  return {over_sea("beside the high sun", "11:55:00", 130, 55),
          over_sea("12:30, 20° up", "12:30:00", 60, 20),
          over_sea("17:45, sun in the back", "17:45:00", 95, 12),
          over_sea("19:00, sun aside", "19:00:00", 195, 10),
          over_sea("19:08, sun in the back", "19:08:00", 105, 10),
          over_sea("stratus from beneath", "14:00:00", 285, 12, stratus),
          over_sea("stratocumulus", "14:00:00", 285, 40, rolls),
          over_sea("closed stratocumulus", "14:00:00", 285, 12, closed),
          over_sea("storm, 14:00", "14:00:00", 0, 0, storm),
          over_sea("storm, 18:00", "18:00:00", 0, 0, storm),
          over_sea("sun -4°, glow ahead", "19:55:00", 285, 10),
          over_sea("sun -4°, glow in the back", "19:55:00", 105, 10),
          over_sea("sun -6°, glow ahead", "20:06:00", 285, 10)};
}

Json path_traced(CloudRun& run, const BenchView& bench_view, const std::vector<std::string>& sets) {
  std::vector<std::string> all = bench_view.sets;
  all.emplace_back("environment.haze=0");
  all.insert(all.end(), sets.begin(), sets.end());
  const Scene scene = make_scene(bench_view.scene, all);
  const FrameView view = still_view(scene, kSize), fine = still_view(scene, kFiner * kSize);
  // What is kept of another view's light and weather has gone by then.
  for (int frame = 0; frame < 8; ++frame) run.march(view);
  std::vector<Pixel> pixels =
      thick_pixels(run.reference(fine, false), run.path_trace(view, kSamples / 2),
                   run.path_trace(view, kSamples / 2, kSamples / 2));
  if (pixels.size() < kFewest) return nullptr;
  std::sort(pixels.begin(), pixels.end(),
            [](const Pixel& a, const Pixel& b) { return a.model < b.model; });
  const std::size_t count = pixels.size(), sixth = count / 6;
  return {{"size", {kSize.x, kSize.y}},
          {"pixels", count},
          {"samples", kSamples},
          {"mean", compared(pixels, 0, count)},
          {"darkest_sixth", compared(pixels, 0, sixth)},
          {"brightest_sixth", compared(pixels, count - sixth, count)}};
}

}  // namespace offing
