#include "game/bench/bench.h"

#include <fmt/core.h>

#include "engine/core/error.h"
#include "engine/io/file.h"
#include "game/render/voyage.h"

namespace offing {
namespace {

// Every pass of the frame, timed one by one.
void bench_frame(const Options& options) {
  Voyage voyage(options, options.size.value_or(glm::ivec2(640, 360)));
  voyage.renderer().graph().set_timing(true);
  for (int frame = 0; frame < options.warmup; ++frame) voyage.next_frame();
  voyage.reset_measures();
  for (int frame = 0; frame < options.frames; ++frame) voyage.next_frame();
  const std::string report = report_of(voyage, options);
  if (options.json.empty()) {
    fmt::print("{}", report);
  } else {
    write_text(options.json, report);
  }
}

}  // namespace

void run_bench(const Options& options) {
  if (options.what != "frame") {
    throw InputError(fmt::format("bench {}: no such benchmark; there is frame", options.what));
  }
  bench_frame(options);
}

}  // namespace offing
