#pragma once

struct GLFWwindow;

namespace offing {

/// Dear ImGui on a window: our fonts and colours, no files written.
class ImGuiLayer {
 public:
  explicit ImGuiLayer(GLFWwindow* window);
  ~ImGuiLayer();
  ImGuiLayer(const ImGuiLayer&) = delete;
  ImGuiLayer& operator=(const ImGuiLayer&) = delete;

  void begin_frame();
  /// Draws into the bound framebuffer.
  void end_frame();
  /// The mouse or the keyboard is on a panel, not at the helm.
  bool wants_mouse() const;
  bool wants_keyboard() const;
};

}  // namespace offing
