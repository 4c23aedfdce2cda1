#include <epoxy/gl.h>
#include <fmt/core.h>
#include <sys/resource.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <utility>
#include <vector>

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

/// What one moment of a sea held.
struct Moment {
  long not_finite = 0;    ///< values of maps, foam and queries
  double highest = 0.0;   ///< |height|, m
  double steepest = 0.0;  ///< |slope|, of one cascade
};

/// A sea that is put into every state there is, and asked for everything it makes.
class StressedSea {
 public:
  StressedSea()
      : shaders_(data_root() / "shaders"),
        graph_(device_),
        ocean_(shaders_, {.cascades = 3, .size = 64, .foam_size = 64}) {}

  void set(const RandomSea& sea, int number) {
    ocean_.set_sea(sea.state, sea.environment, static_cast<std::uint64_t>(number));
  }

  Moment look(double time) {
    graph_.begin_frame();
    const SeaIds ids = ocean_.add_maps(graph_, time);
    OceanView view;
    view.eye = {1e6, -3e5};
    view.time = time;
    const TextureId foam = ocean_.add_foam(graph_, view, ids, true);
    graph_.add(
        "stress.reader",
        [&](PassBuilder& pass) {
          pass.read(ids.displacement).read(ids.slopes).read(foam).side_effect();
        },
        [](PassContext&) {});
    graph_.execute();
    ocean_.collect();
    Moment moment;
    for (const int level : {0, 5}) {
      const auto displacement = ocean_.maps().displacement().read_floats(4, level);
      const auto slopes = ocean_.maps().slopes().read_floats(4, level);
      for (std::size_t i = 0; i < displacement.size(); ++i) {
        if (!std::isfinite(displacement[i])) ++moment.not_finite;
        if (!std::isfinite(slopes[i])) ++moment.not_finite;
        const double slope = std::abs(static_cast<double>(slopes[i]));
        if (i % 4 < 2) moment.steepest = std::max(moment.steepest, slope);
      }
    }
    for (const float value : ocean_.foam().map().read_floats(2)) {
      if (!std::isfinite(value)) ++moment.not_finite;
    }
    ocean_.water().sample(kPlaces, time, samples_);
    for (const WaterSample& sample : samples_) {
      if (!std::isfinite(sample.height + sample.normal.y + sample.velocity.x + sample.velocity.y))
        ++moment.not_finite;
      moment.highest = std::max(moment.highest, std::abs(sample.height));
    }
    return moment;
  }

 private:
  static constexpr std::array<glm::dvec2, 3> kPlaces = {{{0.0, 0.0}, {1e6, -3e5}, {17.0, 23.0}}};
  ShaderLibrary shaders_;
  GlDevice device_;
  FrameGraph graph_;
  Ocean ocean_;
  std::vector<WaterSample> samples_ = std::vector<WaterSample>(kPlaces.size());
};

/// What grew in the second half of a run.
class Growth {
 public:
  void half() { memory_ = resident_mib(), objects_ = gl_objects(); }
  double memory_mib() const { return resident_mib() - memory_; }
  int objects() const { return gl_objects() - objects_; }

 private:
  double memory_ = 0.0;
  int objects_ = 0;
};

}  // namespace

// Random sea states, --frames of them, then an hour of the tallest and of the steepest of them, two
// steps a second: every number finite, no message of the driver, nothing grows.
void bench_stress(const Options& options) {
  const HeadlessContext context;
  gl::require_opengl_45();
  gl::DebugLog log;
  StressedSea stressed;
  const int seed = options.seed.value_or(1);

  Moment all;
  int tallest = 0, steepest = 0;
  Growth growth;
  for (int i = 0; i < options.frames; ++i) {
    if (i == options.frames / 2) growth.half();
    const RandomSea sea = random_sea(seed, i);
    stressed.set(sea, i);
    const Moment moment = stressed.look(sea.time);
    all.not_finite += moment.not_finite;
    if (moment.highest > all.highest) all.highest = moment.highest, tallest = i;
    if (moment.steepest > all.steepest) all.steepest = moment.steepest, steepest = i;
  }
  nlohmann::ordered_json json = {{"states", options.frames},
                                 {"values_not_finite", all.not_finite},
                                 {"highest_water_m", all.highest},
                                 {"steepest_slope", all.steepest},
                                 {"memory_growth_of_second_half_mib", growth.memory_mib()},
                                 {"gl_object_growth_of_second_half", growth.objects()}};

  for (const auto& [name, number] :
       {std::pair{"hour_of_the_tallest", tallest}, std::pair{"hour_of_the_steepest", steepest}}) {
    const RandomSea sea = random_sea(seed, number);
    stressed.set(sea, number);
    constexpr int kSteps = 7200;
    Moment hour;
    for (int step = 0; step < kSteps; ++step) {
      if (step == kSteps / 2) growth.half();
      const Moment moment = stressed.look(sea.time + 0.5 * step);
      hour.not_finite += moment.not_finite;
      hour.highest = std::max(hour.highest, moment.highest);
      hour.steepest = std::max(hour.steepest, moment.steepest);
    }
    json[name] = {{"state", number},
                  {"values_not_finite", hour.not_finite},
                  {"highest_water_m", hour.highest},
                  {"steepest_slope", hour.steepest},
                  {"memory_growth_of_second_half_mib", growth.memory_mib()},
                  {"gl_object_growth_of_second_half", growth.objects()}};
  }
  json["gl_messages"] = log.messages().size();
  deliver_report(options, json.dump(2) + "\n");
}

}  // namespace offing
