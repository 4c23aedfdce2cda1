#include "engine/core/log.h"

#include <cstdio>

namespace offing {

void log_line(LogLevel level, std::string_view text) {
  const char* mark = level == LogLevel::kError     ? "error: "
                     : level == LogLevel::kWarning ? "warning: "
                                                   : "";
  fmt::print(stderr, "offing: {}{}\n", mark, text);
}

}  // namespace offing
