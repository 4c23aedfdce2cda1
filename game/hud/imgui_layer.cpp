#include "game/hud/imgui_layer.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

namespace offing {
namespace {

void set_style() {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 6.0f;
  style.FrameRounding = 3.0f;
  style.WindowBorderSize = 0.0f;
  style.WindowPadding = ImVec2(12.0f, 10.0f);
  const auto set = [&](ImGuiCol which, float r, float g, float b, float a) {
    style.Colors[which] = ImVec4(r, g, b, a);
  };
  set(ImGuiCol_WindowBg, 0.03f, 0.07f, 0.11f, 0.72f);
  set(ImGuiCol_TitleBgActive, 0.05f, 0.16f, 0.24f, 0.9f);
  set(ImGuiCol_FrameBg, 0.10f, 0.18f, 0.25f, 0.8f);
  set(ImGuiCol_SliderGrab, 0.95f, 0.72f, 0.35f, 1.0f);
  set(ImGuiCol_SliderGrabActive, 1.0f, 0.82f, 0.5f, 1.0f);
  set(ImGuiCol_Button, 0.12f, 0.30f, 0.42f, 0.9f);
  set(ImGuiCol_ButtonHovered, 0.18f, 0.42f, 0.56f, 1.0f);
  set(ImGuiCol_Header, 0.10f, 0.26f, 0.36f, 0.8f);
  set(ImGuiCol_CheckMark, 0.95f, 0.72f, 0.35f, 1.0f);
}

}  // namespace

ImGuiLayer::ImGuiLayer(GLFWwindow* window) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // a demo leaves nothing behind
  set_style();
  ImGui_ImplGlfw_InitForOpenGL(window, true);
  ImGui_ImplOpenGL3_Init("#version 450 core");
}

ImGuiLayer::~ImGuiLayer() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

void ImGuiLayer::begin_frame() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void ImGuiLayer::end_frame() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

bool ImGuiLayer::wants_mouse() const { return ImGui::GetIO().WantCaptureMouse; }
bool ImGuiLayer::wants_keyboard() const { return ImGui::GetIO().WantTextInput; }

}  // namespace offing
