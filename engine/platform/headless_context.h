#pragma once
#include <memory>

namespace offing {

/// An OpenGL 4.5 core context without any window: through an EGL device (NVIDIA), or surfaceless
/// (Mesa). Current on the calling thread for as long as it lives.
class HeadlessContext {
 public:
  /// Throws InputError when there is no EGL, or nothing there gives OpenGL 4.5.
  HeadlessContext();
  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace offing
