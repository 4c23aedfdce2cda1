#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace offing {

/// Where what took long to make is kept between runs: $OFFING_CACHE, else $XDG_CACHE_HOME/offing,
/// else ~/.cache/offing. Nothing where there is no home, or where OFFING_CACHE is set but empty.
std::optional<std::filesystem::path> cache_folder();

/// Raises when what is kept changes its meaning.
inline constexpr std::uint32_t kNoiseCacheVersion = 3;

/// The bytes kept in `file` for these parameters, if it is whole: its header names version,
/// parameters, size and a hash of the bytes, and all of them are checked. Otherwise nothing, with a
/// line in the log (none where there is no file).
std::optional<std::string> read_noise_cache(const std::filesystem::path& file,
                                            std::uint64_t parameters, std::size_t bytes);

/// Keeps them; a folder that cannot be written to only costs a line in the log.
void write_noise_cache(const std::filesystem::path& file, std::uint64_t parameters,
                       const std::string& bytes);

}  // namespace offing
