#include "game/bench/stopwatch.h"

#include <epoxy/gl.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <vector>

namespace offing {
namespace {

double processor_ms() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto ms = [](const timeval& t) {
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec);
  };
  return ms(usage.ru_utime) + ms(usage.ru_stime);
}

}  // namespace

Taken time_of(int repeats, const std::function<void()>& work) {
  using Clock = std::chrono::steady_clock;
  work();
  glFinish();
  std::vector<double> times;
  const double before = processor_ms();
  for (int i = 0; i < repeats; ++i) {
    const Clock::time_point begin = Clock::now();
    work();
    glFinish();
    times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
  }
  const double processor = (processor_ms() - before) / repeats;
  std::sort(times.begin(), times.end());
  return {times[times.size() / 2], times.front(), processor};
}

}  // namespace offing
