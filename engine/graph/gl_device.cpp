#include "engine/graph/gl_device.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>

#include "engine/gl/debug.h"

namespace offing {
namespace {
double now_ms() {
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double, std::milli>(Clock::now().time_since_epoch()).count();
}
}  // namespace

GlDevice::GlDevice() : software_(gl::current_renderer().software) {}

GlDevice::~GlDevice() {
  for (const auto& [key, framebuffer] : framebuffers_) glDeleteFramebuffers(1, &framebuffer.id);
  for (const Pending& pending : pending_) {
    free_queries_.push_back(pending.begin);
    free_queries_.push_back(pending.end);
  }
  glDeleteQueries(static_cast<GLsizei>(free_queries_.size()), free_queries_.data());
}

gl::Texture GlDevice::make_texture(const std::string& label, const gl::TextureDesc& desc) {
  return gl::Texture(label, desc);
}
gl::Buffer GlDevice::make_buffer(const std::string& label, std::size_t bytes) {
  return gl::Buffer(label, bytes);
}

void GlDevice::barrier(std::uint32_t bits) { glMemoryBarrier(bits); }

void GlDevice::begin_pass(const std::string& name) {
  glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name.c_str());
}
void GlDevice::end_pass() { glPopDebugGroup(); }

void GlDevice::bind_attachments(const std::vector<const gl::Texture*>& colours,
                                const gl::Texture* depth) {
  std::vector<std::uint64_t> key;
  key.reserve(colours.size() + 2);
  for (const gl::Texture* colour : colours) key.push_back(colour->serial());
  key.push_back(0);
  if (depth != nullptr) key.push_back(depth->serial());
  auto [found, is_new] = framebuffers_.try_emplace(key, Framebuffer{0, frame_});
  Framebuffer& framebuffer = found->second;
  framebuffer.last_used = frame_;
  if (is_new) {
    glCreateFramebuffers(1, &framebuffer.id);
    std::vector<GLenum> targets;
    for (std::size_t i = 0; i < colours.size(); ++i) {
      targets.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
      glNamedFramebufferTexture(framebuffer.id, targets.back(), colours[i]->id(), 0);
    }
    glNamedFramebufferDrawBuffers(framebuffer.id, static_cast<GLsizei>(targets.size()),
                                  targets.data());
    if (depth != nullptr) {
      glNamedFramebufferTexture(framebuffer.id, GL_DEPTH_ATTACHMENT, depth->id(), 0);
    }
  }
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id);
  const gl::Texture* shape = colours.empty() ? depth : colours.front();
  if (shape != nullptr) glViewport(0, 0, shape->width(), shape->height());
}

GLuint GlDevice::take_query() {
  GLuint query = 0;
  if (free_queries_.empty()) {
    glCreateQueries(GL_TIMESTAMP, 1, &query);
  } else {
    query = free_queries_.back();
    free_queries_.pop_back();
  }
  return query;
}

void GlDevice::begin_timer(std::size_t pass) {
  Open timer{pass, 0.0, 0};
  if (software_) {
    glFinish();
    timer.started_ms = now_ms();
  } else {
    timer.query = take_query();
    glQueryCounter(timer.query, GL_TIMESTAMP);
  }
  open_.push_back(timer);
}

void GlDevice::end_timer() {
  const Open timer = open_.back();
  open_.pop_back();
  if (software_) {
    glFinish();
    known_.push_back({timer.pass, now_ms() - timer.started_ms});
  } else {
    const GLuint end = take_query();
    glQueryCounter(end, GL_TIMESTAMP);
    pending_.push_back({timer.pass, timer.query, end});
  }
}

std::vector<GraphDevice::Time> GlDevice::collect_times() {
  while (!pending_.empty()) {
    const Pending pending = pending_.front();
    GLint available = GL_FALSE;
    glGetQueryObjectiv(pending.end, GL_QUERY_RESULT_AVAILABLE, &available);
    if (available == GL_FALSE) break;
    GLuint64 begin = 0, end = 0;
    glGetQueryObjectui64v(pending.begin, GL_QUERY_RESULT, &begin);
    glGetQueryObjectui64v(pending.end, GL_QUERY_RESULT, &end);
    known_.push_back({pending.pass, static_cast<double>(end - begin) * 1e-6});
    free_queries_.push_back(pending.begin);
    free_queries_.push_back(pending.end);
    pending_.pop_front();
  }
  ++frame_;
  forget_old_framebuffers();
  return std::exchange(known_, {});
}

void GlDevice::forget_old_framebuffers() {
  constexpr std::uint64_t kFramesKept = 120;
  std::erase_if(framebuffers_, [&](const auto& entry) {
    const bool old = entry.second.last_used + kFramesKept < frame_;
    if (old) glDeleteFramebuffers(1, &entry.second.id);
    return old;
  });
}

}  // namespace offing
