#include <fmt/core.h>

#include <cstdio>
#include <exception>

#include "engine/core/error.h"
#include "engine/core/log.h"
#include "game/bench/bench.h"
#include "game/export/export.h"
#include "game/options.h"
#include "game/play/play.h"
#include "game/render/render.h"

int main(int count, char** arguments) {
  using namespace offing;
  try {
    const CommandLine line = parse_command_line(count, arguments);
    if (!line.text.empty()) {
      fmt::print("{}", line.text);
      return 0;
    }
    const Options& options = line.options;
    if (options.verb == "render") {
      run_render(options);
    } else if (options.verb == "export") {
      run_export(options);
    } else if (options.verb == "bench") {
      run_bench(options);
    } else {
      run_play(options);
    }
    return static_cast<int>(ExitCode::kDone);
  } catch (const Error& error) {
    log_line(LogLevel::kError, error.what());
    return static_cast<int>(error.code());
  } catch (const std::exception& error) {
    log_line(LogLevel::kError, error.what());
    return static_cast<int>(ExitCode::kFailed);
  }
}
