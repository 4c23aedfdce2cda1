#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace offing {

/// The whole file. Throws InputError: "{file}: cannot be read: {why}; {what to do}".
std::string read_text(const std::filesystem::path& file);

/// Writes all of it or nothing: to a temporary file beside it, then renamed. Throws InputError
/// where the folder is missing, Error (exit code 1) where the disk is full.
void write_text(const std::filesystem::path& file, std::string_view text);

}  // namespace offing
