#pragma once
#include <cstddef>
#include <span>
#include <string>

#include "engine/gl/object.h"

namespace offing::gl {

void delete_buffer(GLuint id);

/// Device memory of a fixed size in bytes.
class Buffer {
 public:
  Buffer() = default;
  /// `flags` as for glNamedBufferStorage. Contents are undefined without `data`.
  Buffer(const std::string& label, std::size_t size, GLbitfield flags = GL_DYNAMIC_STORAGE_BIT,
         const void* data = nullptr);

  template <class T>
  static Buffer of(const std::string& label, std::span<const T> values, GLbitfield flags = 0) {
    return Buffer(label, values.size_bytes(), flags, values.data());
  }

  GLuint id() const { return object_.id(); }
  std::size_t size() const { return size_; }
  explicit operator bool() const { return static_cast<bool>(object_); }

  /// Replaces `size` bytes from `offset`; needs GL_DYNAMIC_STORAGE_BIT.
  void write(const void* data, std::size_t size, std::size_t offset = 0) const;
  template <class T>
  void write(const T& value) const {
    write(&value, sizeof(T));
  }
  /// Synchronous: for tests and exports, never in a frame.
  void read(void* data, std::size_t size, std::size_t offset = 0) const;

  void bind_uniform(GLuint binding) const;
  void bind_storage(GLuint binding) const;

 private:
  Object<delete_buffer> object_;
  std::size_t size_ = 0;
};

}  // namespace offing::gl
