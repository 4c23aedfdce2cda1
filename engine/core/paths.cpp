#include "engine/core/paths.h"

#include <fmt/core.h>

#include <cstdlib>

#include "engine/core/error.h"

namespace offing {
namespace {
namespace fs = std::filesystem;

bool holds_data(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_directory(folder / "shaders", ignored) &&
         fs::is_directory(folder / "assets", ignored);
}

fs::path find_root() {
  if (const char* root = std::getenv("OFFING_ROOT")) {
    if (holds_data(root)) return root;
    throw InputError(fmt::format("OFFING_ROOT={}: no shaders/ and assets/ there; unset it", root));
  }
  std::error_code ignored;
  for (fs::path folder = fs::read_symlink("/proc/self/exe", ignored); folder.has_relative_path();) {
    folder = folder.parent_path();
    if (holds_data(folder)) return folder;
  }
  if (holds_data(OFFING_SOURCE_DIR)) return OFFING_SOURCE_DIR;
  throw InputError(
      "shaders/ and assets/ not found near the program; set OFFING_ROOT to their folder");
}
}  // namespace

const fs::path& data_root() {
  static const fs::path root = find_root();
  return root;
}

const char* version() { return OFFING_VERSION; }

}  // namespace offing
