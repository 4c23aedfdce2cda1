#include "engine/gl/readback.h"

#include <fmt/core.h>

namespace offing::gl {

ReadbackRing::ReadbackRing(const std::string& label, std::size_t size, int slots)
    : slots_(static_cast<std::size_t>(slots)) {
  constexpr GLbitfield kFlags = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    Slot& slot = slots_[i];
    slot.buffer = Buffer(fmt::format("{} {}", label, i), size, kFlags | GL_CLIENT_STORAGE_BIT);
    slot.mapped = static_cast<const std::byte*>(
        glMapNamedBufferRange(slot.buffer.id(), 0, static_cast<GLsizeiptr>(size), kFlags));
  }
}

ReadbackRing::~ReadbackRing() {
  for (const Slot& slot : slots_) {
    if (slot.fence != nullptr) glDeleteSync(slot.fence);
    glUnmapNamedBuffer(slot.buffer.id());
  }
}

GLuint ReadbackRing::begin() {
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    if (slots_[i].fence == nullptr && static_cast<int>(i) != held_) {
      writing_ = static_cast<int>(i);
      return slots_[i].buffer.id();
    }
  }
  writing_ = -1;
  return 0;
}

void ReadbackRing::issue(double tag) {
  if (writing_ < 0) return;
  Slot& slot = slots_[static_cast<std::size_t>(writing_)];
  glMemoryBarrier(GL_CLIENT_MAPPED_BUFFER_BARRIER_BIT);
  slot.fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  slot.tag = tag;
  slot.sequence = ++issued_;
  writing_ = -1;
}

bool ReadbackRing::poll(Result* out) {
  int newest = -1;
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    Slot& slot = slots_[i];
    if (slot.fence == nullptr) continue;
    const GLenum state = glClientWaitSync(slot.fence, 0, 0);
    if (state != GL_ALREADY_SIGNALED && state != GL_CONDITION_SATISFIED) continue;
    glDeleteSync(slot.fence);
    slot.fence = nullptr;
    // Fences are signalled in the order of their commands, but slots are reused in any order.
    if (newest < 0 || slot.sequence > slots_[static_cast<std::size_t>(newest)].sequence) {
      newest = static_cast<int>(i);
    }
  }
  if (newest < 0) return false;
  held_ = newest;
  const Slot& slot = slots_[static_cast<std::size_t>(newest)];
  *out = {slot.tag, {slot.mapped, slot.buffer.size()}};
  return true;
}

bool ReadbackRing::poll_oldest(Result* out) {
  int oldest = -1;
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    if (slots_[i].fence == nullptr) continue;
    if (oldest < 0 || slots_[i].sequence < slots_[static_cast<std::size_t>(oldest)].sequence) {
      oldest = static_cast<int>(i);
    }
  }
  if (oldest < 0) return false;
  Slot& slot = slots_[static_cast<std::size_t>(oldest)];
  const GLenum state = glClientWaitSync(slot.fence, 0, 0);
  if (state != GL_ALREADY_SIGNALED && state != GL_CONDITION_SATISFIED) return false;
  glDeleteSync(slot.fence);
  slot.fence = nullptr;
  held_ = oldest;
  *out = {slot.tag, {slot.mapped, slot.buffer.size()}};
  return true;
}

}  // namespace offing::gl
