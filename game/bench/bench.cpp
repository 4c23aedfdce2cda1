#include "game/bench/bench.h"

#include <fmt/core.h>

#include <map>

#include "engine/core/error.h"
#include "game/bench/benches.h"

namespace offing {

void run_bench(const Options& options) {
  static const std::map<std::string, void (*)(const Options&)> benches = {
      {"boat", bench_boat},
      {"frame", bench_frame},
      {"ocean", bench_ocean},
      {"probe", bench_probe},
      {"query", bench_query},
      {"stress", bench_stress},
  };
  const auto found = benches.find(options.what);
  if (found == benches.end()) {
    std::string names;
    for (const auto& [name, function] : benches) names += (names.empty() ? "" : ", ") + name;
    throw InputError(fmt::format("bench {}: no such benchmark; there are {}", options.what, names));
  }
  found->second(options);
}

}  // namespace offing
