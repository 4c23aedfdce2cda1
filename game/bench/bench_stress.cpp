#include <epoxy/gl.h>
#include <fmt/core.h>
#include <sys/resource.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>

#include "engine/core/paths.h"
#include "engine/gl/debug.h"
#include "engine/graph/gl_device.h"
#include "engine/ocean/ocean.h"
#include "engine/platform/headless_context.h"
#include "game/bench/bench_report.h"
#include "game/bench/benches.h"
#include "game/world/random_sea.h"

namespace offing {
namespace {

// Memory of this process, MiB.
double resident_mib() {
  std::ifstream statm("/proc/self/statm");
  double pages = 0.0, resident = 0.0;
  statm >> pages >> resident;
  return resident * 4096.0 / 1048576.0;
}

// How many names of each kind exist below a bound that no run of ours reaches.
int gl_objects() {
  int count = 0;
  for (GLuint name = 1; name < 4096; ++name) {
    count += glIsBuffer(name) + glIsTexture(name) + glIsProgram(name);
  }
  return count;
}

}  // namespace

// Random sea states, --frames of them: every number finite, no message of the driver, nothing
// grows.
void bench_stress(const Options& options) {
  const HeadlessContext context;
  gl::require_opengl_45();
  gl::DebugLog log;
  ShaderLibrary shaders(data_root() / "shaders");
  GlDevice device;
  FrameGraph graph(device);
  Ocean ocean(shaders, {.cascades = 3, .size = 64});
  const std::vector<glm::dvec2> places = {{0.0, 0.0}, {1e6, -3e5}, {17.0, 23.0}};
  std::vector<WaterSample> samples(places.size());
  long bad_maps = 0, bad_samples = 0;
  double highest = 0.0, memory = 0.0;
  int objects = 0;
  for (int i = 0; i < options.frames; ++i) {
    const RandomSea sea = random_sea(options.seed.value_or(1), i);
    ocean.set_sea(sea.state, sea.environment, static_cast<std::uint64_t>(i));
    graph.begin_frame();
    const SeaIds ids = ocean.add_maps(graph, sea.time);
    graph.add(
        "stress.reader",
        [&](PassBuilder& pass) { pass.read(ids.displacement).read(ids.slopes).side_effect(); },
        [](PassContext&) {});
    graph.execute();
    ocean.collect();
    for (const gl::Texture* map : {&ocean.maps().displacement(), &ocean.maps().slopes()}) {
      for (const int level : {0, 5}) {
        for (const float value : map->read_floats(4, level)) {
          if (!std::isfinite(value)) ++bad_maps;
        }
      }
    }
    ocean.water().sample(places, sea.time, samples);
    for (const WaterSample& sample : samples) {
      if (!std::isfinite(sample.height + sample.normal.y + sample.velocity.x + sample.velocity.y))
        ++bad_samples;
      highest = std::max(highest, std::abs(sample.height));
    }
    if (i == options.frames / 2) {
      memory = resident_mib();
      objects = gl_objects();
    }
  }
  const nlohmann::ordered_json json = {
      {"states", options.frames},
      {"values_not_finite", bad_maps},
      {"samples_not_finite", bad_samples},
      {"gl_messages", log.messages().size()},
      {"highest_water_m", highest},
      {"memory_growth_of_second_half_mib", resident_mib() - memory},
      {"gl_object_growth_of_second_half", gl_objects() - objects}};
  deliver_report(options, json.dump(2) + "\n");
}

}  // namespace offing
