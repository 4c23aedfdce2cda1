#include "game/bench/bench_report.h"

#include <fmt/core.h>

#include "engine/io/file.h"

namespace offing {

void deliver_report(const Options& options, const std::string& json) {
  if (options.json.empty()) {
    fmt::print("{}", json);
  } else {
    write_text(options.json, json);
  }
}

}  // namespace offing
