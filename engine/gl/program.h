#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/gl/object.h"

namespace offing::gl {

void delete_program(GLuint id);
void delete_vertex_array(GLuint id);

/// A stage that does not compile (`stage` its GL name), or a program that does not link (0). The
/// message is the driver's log.
class ShaderError : public Error {
 public:
  ShaderError(const std::string& label, GLenum stage, const std::string& log)
      : Error(label + ": " + log, ExitCode::kBadInput), stage_(stage) {}
  GLenum stage() const { return stage_; }

 private:
  GLenum stage_;
};

/// One stage's complete GLSL text.
struct StageSource {
  GLenum stage;
  std::string text;
};

/// A linked program. Uniforms are set by their `layout(location = n)`, never by name.
class Program {
 public:
  Program() = default;
  /// Throws ShaderError where a stage or the link fails.
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
  void set(int location, glm::ivec4 value) const;
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
