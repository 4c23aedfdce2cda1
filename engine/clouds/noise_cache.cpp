#include "engine/clouds/noise_cache.h"

#include <cstdlib>
#include <cstring>
#include <string_view>
#include <system_error>

#include "engine/core/error.h"
#include "engine/core/log.h"
#include "engine/core/random.h"
#include "engine/io/file.h"

namespace offing {
namespace {

struct Header {
  char magic[8];
  std::uint32_t version;
  std::uint32_t reserved;
  std::uint64_t parameters;
  std::uint64_t size;
  std::uint64_t hash;
};
static_assert(sizeof(Header) == 40);
constexpr char kMagic[8] = {'O', 'F', 'F', 'N', 'O', 'I', 'S', 'E'};

const char* what_is_wrong(std::string_view text, std::uint64_t parameters, std::size_t bytes) {
  Header header;
  if (text.size() < sizeof(header)) return "is cut short";
  std::memcpy(&header, text.data(), sizeof(header));
  if (std::memcmp(header.magic, kMagic, sizeof(kMagic)) != 0) return "is no noise cache";
  if (header.version != kNoiseCacheVersion) return "is of another version";
  if (header.parameters != parameters) return "was made with other parameters";
  if (header.size != bytes) return "has another size";
  if (text.size() != sizeof(header) + bytes) return "is cut short";
  if (hash_bytes(text.data() + sizeof(header), bytes) != header.hash) return "is damaged";
  return nullptr;
}

}  // namespace

std::optional<std::filesystem::path> cache_folder() {
  if (const char* own = std::getenv("OFFING_CACHE")) {
    if (*own == '\0') return std::nullopt;
    return std::filesystem::path(own);
  }
  if (const char* xdg = std::getenv("XDG_CACHE_HOME"); xdg != nullptr && *xdg == '/') {
    return std::filesystem::path(xdg) / "offing";
  }
  if (const char* home = std::getenv("HOME"); home != nullptr && *home == '/') {
    return std::filesystem::path(home) / ".cache" / "offing";
  }
  return std::nullopt;
}

std::optional<std::string> read_noise_cache(const std::filesystem::path& file,
                                            std::uint64_t parameters, std::size_t bytes) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return std::nullopt;
  try {
    std::string text = read_text(file);
    if (const char* wrong = what_is_wrong(text, parameters, bytes)) {
      log_warning("{} {}: made again", file.string(), wrong);
      return std::nullopt;
    }
    return text.substr(sizeof(Header));
  } catch (const Error& problem) {
    log_warning("{}: made again", problem.what());
    return std::nullopt;
  }
}

void write_noise_cache(const std::filesystem::path& file, std::uint64_t parameters,
                       const std::string& bytes) {
  Header header{};
  std::memcpy(header.magic, kMagic, sizeof(kMagic));
  header.version = kNoiseCacheVersion;
  header.parameters = parameters;
  header.size = bytes.size();
  header.hash = hash_bytes(bytes.data(), bytes.size());
  std::string text(sizeof(header), '\0');
  std::memcpy(text.data(), &header, sizeof(header));
  text += bytes;
  try {
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    write_text(file, text);
  } catch (const Error& problem) {
    log_warning("clouds: noise is not kept: {}", problem.what());
  }
}

}  // namespace offing
