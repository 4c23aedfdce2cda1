#pragma once
#include <fmt/core.h>

#include <string_view>
#include <utility>

namespace offing {

enum class LogLevel { kInfo, kWarning, kError };

/// Writes one line to stderr: "offing: text", "offing: warning: text" or "offing: error: text".
void log_line(LogLevel level, std::string_view text);

template <class... Args>
void log_info(fmt::format_string<Args...> format, Args&&... args) {
  log_line(LogLevel::kInfo, fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void log_warning(fmt::format_string<Args...> format, Args&&... args) {
  log_line(LogLevel::kWarning, fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace offing
