#include "game/bench/bench_report.h"
#include "game/bench/benches.h"
#include "game/render/voyage.h"

namespace offing {

// Every pass of the frame, timed one by one.
void bench_frame(const Options& options) {
  Voyage voyage(options, options.size.value_or(glm::ivec2(640, 360)));
  voyage.renderer().graph().set_timing(true);
  for (int frame = 0; frame < options.warmup; ++frame) voyage.next_frame();
  voyage.reset_measures();
  for (int frame = 0; frame < options.frames; ++frame) voyage.next_frame();
  deliver_report(options, report_of(voyage, options));
}

}  // namespace offing
