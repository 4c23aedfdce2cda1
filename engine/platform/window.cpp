#include "engine/platform/window.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "engine/core/error.h"

namespace offing {
namespace {

constexpr int kMajor = 4, kMinor = 5;

// GLFW is one per process; it stays up while anything here uses it.
int glfw_users = 0;

bool acquire_glfw() {
  if (glfw_users == 0 && glfwInit() != GLFW_TRUE) return false;
  ++glfw_users;
  return true;
}

void release_glfw() {
  if (--glfw_users == 0) glfwTerminate();
}

std::string last_glfw_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text != nullptr ? text : "no reason given";
}

// What the driver gives to those who ask for nothing in particular.
std::string default_opengl_version() {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  GLFWwindow* probe = glfwCreateWindow(16, 16, "Offing", nullptr, nullptr);
  if (probe == nullptr) return "none";
  glfwMakeContextCurrent(probe);
  std::string version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
  glfwDestroyWindow(probe);
  return version;
}

}  // namespace

bool Window::display_available() {
  if (!acquire_glfw()) return false;
  release_glfw();
  return true;
}

Window::Window(const Options& options) {
  if (!acquire_glfw()) {
    throw InputError(
        fmt::format("no display: {}; set DISPLAY, or use the verb `render`", last_glfw_error()));
  }
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, kMajor);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, kMinor);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);
  glfwWindowHint(GLFW_VISIBLE, options.visible ? GLFW_TRUE : GLFW_FALSE);
  // The scene is drawn into textures of its own; the window only gets the finished picture.
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "offing");
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "offing");

  window_ =
      glfwCreateWindow(options.size.x, options.size.y, options.title.c_str(), nullptr, nullptr);
  if (window_ == nullptr) {
    const std::string reason = last_glfw_error();
    const std::string found = default_opengl_version();
    release_glfw();
    throw InputError(fmt::format(
        "no window: it needs OpenGL {}.{} core and the display's driver has {} ({}); update the "
        "driver, or use another display",
        kMajor, kMinor, found, reason));
  }
  glfwMakeContextCurrent(window_);
  set_vsync(options.vsync);
}

Window::~Window() {
  glfwDestroyWindow(window_);
  release_glfw();
}

void Window::poll_events() { glfwPollEvents(); }
void Window::wait_events(double seconds) { glfwWaitEventsTimeout(seconds); }
void Window::swap() { glfwSwapBuffers(window_); }

glm::ivec2 Window::framebuffer_size() const {
  glm::ivec2 size;
  glfwGetFramebufferSize(window_, &size.x, &size.y);
  return size;
}

bool Window::minimised() const {
  const glm::ivec2 size = framebuffer_size();
  return glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE || size.x <= 0 || size.y <= 0;
}

float Window::content_scale() const {
  float x = 1.0f, y = 1.0f;
  glfwGetWindowContentScale(window_, &x, &y);
  return x;
}

bool Window::should_close() const { return glfwWindowShouldClose(window_) == GLFW_TRUE; }
void Window::request_close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }
void Window::resize(glm::ivec2 size) { glfwSetWindowSize(window_, size.x, size.y); }
void Window::set_vsync(bool on) { glfwSwapInterval(on ? 1 : 0); }

}  // namespace offing
