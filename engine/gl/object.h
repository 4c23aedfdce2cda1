#pragma once
#include <epoxy/gl.h>

#include <utility>

namespace offing::gl {

/// Owns one OpenGL name: move-only, deleted with `Delete` when it goes.
template <auto Delete>
class Object {
 public:
  Object() = default;
  explicit Object(GLuint id) : id_(id) {}
  Object(Object&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  Object& operator=(Object&& other) noexcept {
    if (this != &other) {
      reset();
      id_ = std::exchange(other.id_, 0);
    }
    return *this;
  }
  ~Object() { reset(); }

  GLuint id() const { return id_; }
  explicit operator bool() const { return id_ != 0; }

 private:
  void reset() {
    if (id_ != 0) Delete(id_);
    id_ = 0;
  }
  GLuint id_ = 0;
};

}  // namespace offing::gl
