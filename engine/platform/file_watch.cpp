#include "engine/platform/file_watch.h"

#include <string>
#include <system_error>
#include <utility>

#include "engine/core/random.h"

namespace offing {

FileWatch::FileWatch(std::filesystem::path folder) : folder_(std::move(folder)), seen_(look()) {}

bool FileWatch::changed(double now) {
  if (now < next_look_) return false;
  next_look_ = now + kInterval;
  const std::uint64_t before = std::exchange(seen_, look());
  return seen_ != before;
}

// A sum, since a folder's order may change while its files do not. Files come and go while we look
// (editors write a new one and rename it), so every question may fail without harm.
std::uint64_t FileWatch::look() const {
  namespace fs = std::filesystem;
  std::uint64_t sum = 0;
  std::error_code error;
  fs::recursive_directory_iterator files(folder_, error);
  for (; !error && files != fs::recursive_directory_iterator(); files.increment(error)) {
    std::error_code gone;
    const auto written = files->last_write_time(gone).time_since_epoch().count();
    if (gone || !files->is_regular_file(gone)) continue;
    const std::uintmax_t size = files->file_size(gone);
    const std::string& name = files->path().native();
    sum += hash_bytes(name.data(), name.size(), hash_of(written, size));
  }
  return sum;
}

}  // namespace offing
