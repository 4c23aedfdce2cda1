#include <fmt/core.h>

#include "engine/core/error.h"
#include "engine/gl/debug.h"
#include "engine/io/image.h"
#include "engine/platform/headless_context.h"
#include "game/export/cloud_run.h"
#include "game/export/exports.h"
#include "game/frame/quality.h"

namespace offing {
namespace {

constexpr int kSamples = 64;      // paths a pixel where --samples says nothing
constexpr int kStillFrames = 40;  // two rounds of the sparsest march and some more

}  // namespace

// The low clouds as the scene's camera sees them, before nothing: radiance, transmittance,
// distance.
void export_clouds(const Scene& scene, const Options& options) {
  const std::string& method = options.method;
  if (!method.empty() && method != "march" && method != "reference" && method != "pathtrace") {
    throw InputError(fmt::format("--method {}: clouds has march, reference and pathtrace", method));
  }
  check_image_name(options.out);
  const HeadlessContext context;
  gl::require_opengl_45();
  const Quality quality = quality_named(options.quality, gl::current_renderer().software);
  const FrameView view = still_view(scene, options.size.value_or(glm::ivec2(160, 90)));
  CloudRun run(CloudQuality::of(quality.level));
  CloudSightings clouds;
  if (method == "reference") {
    clouds = run.reference(view);
  } else if (method == "pathtrace") {
    clouds = run.path_trace(view, options.samples.value_or(kSamples));
  } else {
    for (int frame = 0; frame < kStillFrames; ++frame) run.march(view);
    clouds = run.marched(view);
  }
  Image image{clouds.size.x, clouds.size.y, 5, {}, {}};
  for (int y = clouds.size.y - 1; y >= 0; --y) {
    for (int x = 0; x < clouds.size.x; ++x) {
      const auto at = static_cast<std::size_t>(y * clouds.size.x + x);
      for (int c = 0; c < 4; ++c) image.pixels.push_back(clouds.light[at][c]);
      image.pixels.push_back(clouds.distance[at]);
    }
  }
  write_image(options.out, image, {"R", "G", "B", "transmittance", "depth"},
              {{"time_s", view.clouds.elapsed}, {"exposure", view.light.exposure}});
}

}  // namespace offing
