#pragma once
#include <glm/vec2.hpp>

#include <string>

struct GLFWwindow;

namespace offing {

/// A window with an OpenGL 4.5 core context, current on the thread that made it for as long as the
/// window lives. All of it, and Input's polling, belongs on the main thread (GLFW's rule).
class Window {
 public:
  struct Options {
    std::string title = "Offing";
    glm::ivec2 size{1280, 720};  ///< in screen coordinates; framebuffer_size() is what is drawn to
    bool vsync = true;
    bool visible = true;
  };

  /// Throws InputError: "no display: …" where there is none to open, and one that names the version
  /// found where the driver there has no OpenGL 4.5.
  explicit Window(const Options& options);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Whether a display answers. A variable that names a display which is not there counts as none.
  static bool display_available();

  /// Hands the events that have come in to the callbacks.
  void poll_events();
  /// The same, but sleeps until the first event or for `seconds`: for a window nobody sees.
  void wait_events(double seconds);
  void swap();

  /// In pixels; zero while minimised on some systems, so ask minimised() before drawing.
  glm::ivec2 framebuffer_size() const;
  /// True while there is nothing to draw to: an icon, or a framebuffer without any pixels.
  bool minimised() const;
  /// Pixels per screen coordinate, for the size of text.
  float content_scale() const;

  bool should_close() const;
  void request_close();
  void resize(glm::ivec2 size);
  void set_vsync(bool on);

  /// For Input and the panels' backend.
  GLFWwindow* handle() const { return window_; }

 private:
  GLFWwindow* window_ = nullptr;
};

}  // namespace offing
