#pragma once
#include <cstdint>
#include <filesystem>

namespace offing {

/// Notices that a file in a folder, or in one below it, was written, added, removed or renamed.
/// Looks at names, sizes and times of writing, at most every kInterval; some 0.2 ms per 100 files.
class FileWatch {
 public:
  static constexpr double kInterval = 0.25;  ///< s

  /// A folder that is not there (yet) counts as empty.
  explicit FileWatch(std::filesystem::path folder);

  /// Whether anything changed since the last time this said so. `now` is the caller's clock, in
  /// seconds, never going back.
  bool changed(double now);

 private:
  std::uint64_t look() const;

  std::filesystem::path folder_;
  std::uint64_t seen_;
  double next_look_ = 0.0;
};

}  // namespace offing
