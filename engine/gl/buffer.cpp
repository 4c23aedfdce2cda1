#include "engine/gl/buffer.h"

namespace offing::gl {

void delete_buffer(GLuint id) { glDeleteBuffers(1, &id); }

Buffer::Buffer(const std::string& label, std::size_t size, GLbitfield flags, const void* data)
    : size_(size) {
  GLuint id = 0;
  glCreateBuffers(1, &id);
  object_ = Object<delete_buffer>(id);
  glNamedBufferStorage(id, static_cast<GLsizeiptr>(size), data, flags);
  glObjectLabel(GL_BUFFER, id, -1, label.c_str());
}

void Buffer::write(const void* data, std::size_t size, std::size_t offset) const {
  glNamedBufferSubData(id(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(size), data);
}

void Buffer::read(void* data, std::size_t size, std::size_t offset) const {
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetNamedBufferSubData(id(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(size), data);
}

void Buffer::bind_uniform(GLuint binding) const {
  glBindBufferBase(GL_UNIFORM_BUFFER, binding, id());
}
void Buffer::bind_storage(GLuint binding) const {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, id());
}

}  // namespace offing::gl
