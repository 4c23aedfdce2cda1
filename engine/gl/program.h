#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <string>
#include <vector>

#include "engine/gl/object.h"

namespace offing::gl {

void delete_program(GLuint id);
void delete_vertex_array(GLuint id);

/// One stage's complete GLSL text.
struct StageSource {
  GLenum stage;
  std::string text;
};

/// A linked program. Uniforms are set by their `layout(location = n)`, never by name.
class Program {
 public:
  Program() = default;
  /// Throws Error with the driver's log, stage by stage, where a stage or the link fails.
  Program(const std::string& label, const std::vector<StageSource>& stages);

  GLuint id() const { return object_.id(); }
  explicit operator bool() const { return static_cast<bool>(object_); }
  void use() const;

  void set(int location, int value) const;
  void set(int location, unsigned value) const;
  void set(int location, float value) const;
  void set(int location, glm::vec2 value) const;
  void set(int location, glm::vec3 value) const;
  void set(int location, glm::vec4 value) const;
  void set(int location, glm::ivec2 value) const;
  void set(int location, const glm::mat4& value) const;

 private:
  Object<delete_program> object_;
};

/// A vertex layout without buffers attached to it by global state.
class VertexArray {
 public:
  VertexArray() = default;
  explicit VertexArray(const std::string& label);
  GLuint id() const { return object_.id(); }
  void bind() const;
  /// Attribute `location` of `components` floats at `offset` in a vertex of `stride` bytes.
  void attribute(GLuint location, int components, GLuint buffer, int stride, int offset) const;
  void index_buffer(GLuint buffer) const;

 private:
  Object<delete_vertex_array> object_;
};

}  // namespace offing::gl
