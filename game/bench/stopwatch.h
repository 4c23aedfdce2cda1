#pragma once
#include <functional>

namespace offing {

/// What running something took, ms: by the clock, and of the processor (all threads of this process
/// together; what a GPU does is not in it).
struct Taken {
  double median = 0.0, least = 0.0, processor = 0.0;
};

/// Runs `work` once to warm up, then `repeats` times, each finished on the GPU before the next.
Taken time_of(int repeats, const std::function<void()>& work);

}  // namespace offing
