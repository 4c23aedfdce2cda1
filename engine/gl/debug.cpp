#include "engine/gl/debug.h"

#include <epoxy/gl.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "engine/core/error.h"

namespace offing::gl {
namespace {
const char* severity_name(GLenum severity) {
  switch (severity) {
    case GL_DEBUG_SEVERITY_HIGH:
      return "high";
    case GL_DEBUG_SEVERITY_MEDIUM:
      return "medium";
    default:
      return "low";
  }
}

void on_message(GLenum, GLenum type, GLuint id, GLenum severity, GLsizei, const GLchar* text,
                const void* user) {
  if (severity == GL_DEBUG_SEVERITY_NOTIFICATION) return;
  if (type == GL_DEBUG_TYPE_PUSH_GROUP || type == GL_DEBUG_TYPE_POP_GROUP) return;
  auto* log = static_cast<DebugLog*>(const_cast<void*>(user));
  log->add({type == GL_DEBUG_TYPE_ERROR,
            fmt::format("GL {} ({}): {}", severity_name(severity), id, text)});
}

std::string string_of(GLenum name) {
  const auto* text = reinterpret_cast<const char*>(glGetString(name));
  return text != nullptr ? text : "";
}
}  // namespace

DebugLog::DebugLog() {
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(on_message, this);
}

DebugLog::~DebugLog() { glDebugMessageCallback(nullptr, nullptr); }

void DebugLog::add(Message message) { messages_.push_back(std::move(message)); }

DebugGroup::DebugGroup(const char* label) {
  glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, label);
}
DebugGroup::~DebugGroup() { glPopDebugGroup(); }

Renderer current_renderer() {
  Renderer renderer{string_of(GL_RENDERER), string_of(GL_VENDOR), string_of(GL_VERSION), false};
  std::string lower = renderer.name;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  constexpr std::array kSoftware = {"llvmpipe", "softpipe", "swrast", "swiftshader"};
  renderer.software = std::any_of(kSoftware.begin(), kSoftware.end(), [&](const char* name) {
    return lower.find(name) != std::string::npos;
  });
  return renderer;
}

void require_opengl_45() {
  const int version = epoxy_gl_version();
  if (version < 45) {
    throw InputError(fmt::format(
        "OpenGL {}.{} on {}: 4.5 is needed; install a newer graphics driver, or Mesa 22 or later",
        version / 10, version % 10, string_of(GL_RENDERER)));
  }
}

}  // namespace offing::gl
