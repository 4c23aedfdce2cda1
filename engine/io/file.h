#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace offing {

/// The whole file, bytes as they are. Throws InputError: "{file}: cannot be read: {why}; {what to
/// do}", also for a folder and for more than `max_bytes`.
std::string read_text(const std::filesystem::path& file, std::size_t max_bytes = 256u << 20);

/// Writes all bytes or nothing: to a temporary file in the same folder, then renamed over `file`. A
/// device or pipe that is there already is written to directly, and never replaced. Throws
/// InputError where the folder is missing or closed to us, Error (exit code 1) where writing fails,
/// as on a full disk; the temporary file is gone then and an older `file` untouched.
void write_text(const std::filesystem::path& file, std::string_view text);

}  // namespace offing
