#pragma once
#include <filesystem>
#include <string>

namespace offing::test {

/// An empty folder of the running test's own, gone with this object. Tests run beside each other,
/// each as a process: whatever they write has to be theirs alone.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::filesystem::path& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace offing::test
