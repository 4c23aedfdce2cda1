#include "engine/gl/program.h"

#include <fmt/core.h>

#include <glm/gtc/type_ptr.hpp>

#include "engine/core/error.h"

namespace offing::gl {
namespace {
void delete_shader(GLuint id) { glDeleteShader(id); }

const char* stage_name(GLenum stage) {
  switch (stage) {
    case GL_VERTEX_SHADER:
      return "vertex";
    case GL_FRAGMENT_SHADER:
      return "fragment";
    case GL_COMPUTE_SHADER:
      return "compute";
    default:
      return "shader";
  }
}

Object<delete_shader> compile(const std::string& label, const StageSource& source) {
  Object<delete_shader> shader(glCreateShader(source.stage));
  const char* text = source.text.c_str();
  glShaderSource(shader.id(), 1, &text, nullptr);
  glCompileShader(shader.id());
  GLint good = GL_FALSE;
  glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &good);
  if (good == GL_FALSE) {
    GLint length = 0;
    glGetShaderiv(shader.id(), GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    glGetShaderInfoLog(shader.id(), length, nullptr, log.data());
    throw ShaderError(label, source.stage,
                      fmt::format("{} stage: {}", stage_name(source.stage), log.c_str()));
  }
  return shader;
}
}  // namespace

void delete_program(GLuint id) { glDeleteProgram(id); }
void delete_vertex_array(GLuint id) { glDeleteVertexArrays(1, &id); }

Program::Program(const std::string& label, const std::vector<StageSource>& stages) {
  std::vector<Object<delete_shader>> shaders;
  shaders.reserve(stages.size());
  for (const StageSource& stage : stages) shaders.push_back(compile(label, stage));
  Object<delete_program> program(glCreateProgram());
  for (const auto& shader : shaders) glAttachShader(program.id(), shader.id());
  glLinkProgram(program.id());
  for (const auto& shader : shaders) glDetachShader(program.id(), shader.id());
  GLint good = GL_FALSE;
  glGetProgramiv(program.id(), GL_LINK_STATUS, &good);
  if (good == GL_FALSE) {
    GLint length = 0;
    glGetProgramiv(program.id(), GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    glGetProgramInfoLog(program.id(), length, nullptr, log.data());
    throw ShaderError(label, 0, fmt::format("link: {}", log.c_str()));
  }
  glObjectLabel(GL_PROGRAM, program.id(), -1, label.c_str());
  object_ = std::move(program);
}

void Program::use() const { glUseProgram(id()); }

void Program::set(int location, int value) const { glProgramUniform1i(id(), location, value); }
void Program::set(int location, unsigned value) const {
  glProgramUniform1ui(id(), location, value);
}
void Program::set(int location, float value) const { glProgramUniform1f(id(), location, value); }
void Program::set(int location, glm::vec2 value) const {
  glProgramUniform2f(id(), location, value.x, value.y);
}
void Program::set(int location, glm::vec3 value) const {
  glProgramUniform3f(id(), location, value.x, value.y, value.z);
}
void Program::set(int location, glm::vec4 value) const {
  glProgramUniform4f(id(), location, value.x, value.y, value.z, value.w);
}
void Program::set(int location, glm::ivec2 value) const {
  glProgramUniform2i(id(), location, value.x, value.y);
}
void Program::set(int location, glm::ivec4 value) const {
  glProgramUniform4i(id(), location, value.x, value.y, value.z, value.w);
}
void Program::set(int location, const glm::mat4& value) const {
  glProgramUniformMatrix4fv(id(), location, 1, GL_FALSE, glm::value_ptr(value));
}

VertexArray::VertexArray(const std::string& label) {
  GLuint id = 0;
  glCreateVertexArrays(1, &id);
  object_ = Object<delete_vertex_array>(id);
  glObjectLabel(GL_VERTEX_ARRAY, id, -1, label.c_str());
}

void VertexArray::bind() const { glBindVertexArray(id()); }

void VertexArray::attribute(GLuint location, int components, GLuint buffer, int stride,
                            int offset) const {
  glEnableVertexArrayAttrib(id(), location);
  glVertexArrayAttribFormat(id(), location, components, GL_FLOAT, GL_FALSE,
                            static_cast<GLuint>(offset));
  glVertexArrayVertexBuffer(id(), location, buffer, 0, stride);
  glVertexArrayAttribBinding(id(), location, location);
}

void VertexArray::index_buffer(GLuint buffer) const { glVertexArrayElementBuffer(id(), buffer); }

}  // namespace offing::gl
