#include "engine/platform/input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cmath>
#include <optional>

#include "engine/platform/window.h"

namespace offing {
namespace {

struct KeyPair {
  int glfw;
  Key key;
};
constexpr KeyPair kKeys[] = {
    {GLFW_KEY_A, Key::kA},
    {GLFW_KEY_B, Key::kB},
    {GLFW_KEY_C, Key::kC},
    {GLFW_KEY_D, Key::kD},
    {GLFW_KEY_F, Key::kF},
    {GLFW_KEY_G, Key::kG},
    {GLFW_KEY_H, Key::kH},
    {GLFW_KEY_I, Key::kI},
    {GLFW_KEY_O, Key::kO},
    {GLFW_KEY_P, Key::kP},
    {GLFW_KEY_R, Key::kR},
    {GLFW_KEY_S, Key::kS},
    {GLFW_KEY_T, Key::kT},
    {GLFW_KEY_V, Key::kV},
    {GLFW_KEY_W, Key::kW},
    {GLFW_KEY_X, Key::kX},
    {GLFW_KEY_1, Key::kOne},
    {GLFW_KEY_2, Key::kTwo},
    {GLFW_KEY_3, Key::kThree},
    {GLFW_KEY_LEFT, Key::kLeft},
    {GLFW_KEY_RIGHT, Key::kRight},
    {GLFW_KEY_UP, Key::kUp},
    {GLFW_KEY_DOWN, Key::kDown},
    {GLFW_KEY_LEFT_BRACKET, Key::kLeftBracket},
    {GLFW_KEY_RIGHT_BRACKET, Key::kRightBracket},
    {GLFW_KEY_COMMA, Key::kComma},
    {GLFW_KEY_PERIOD, Key::kPeriod},
    {GLFW_KEY_SPACE, Key::kSpace},
    {GLFW_KEY_ESCAPE, Key::kEscape},
    {GLFW_KEY_F1, Key::kF1},
    {GLFW_KEY_F5, Key::kF5},
    {GLFW_KEY_F10, Key::kF10},
    {GLFW_KEY_F12, Key::kF12},
};
static_assert(std::size(kKeys) == static_cast<std::size_t>(Key::kCount));

struct PadPair {
  int glfw;
  PadButton button;
};
constexpr PadPair kPadButtons[] = {
    {GLFW_GAMEPAD_BUTTON_A, PadButton::kA},
    {GLFW_GAMEPAD_BUTTON_X, PadButton::kX},
    {GLFW_GAMEPAD_BUTTON_Y, PadButton::kY},
    {GLFW_GAMEPAD_BUTTON_LEFT_BUMPER, PadButton::kLeftBumper},
    {GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER, PadButton::kRightBumper},
    {GLFW_GAMEPAD_BUTTON_START, PadButton::kStart},
    {GLFW_GAMEPAD_BUTTON_RIGHT_THUMB, PadButton::kRightStick},
};
static_assert(std::size(kPadButtons) == static_cast<std::size_t>(PadButton::kCount));

std::optional<Key> key_from_glfw(int glfw) {
  for (const KeyPair& pair : kKeys) {
    if (pair.glfw == glfw) return pair.key;
  }
  return std::nullopt;
}

std::optional<MouseButton> button_from_glfw(int glfw) {
  switch (glfw) {
    case GLFW_MOUSE_BUTTON_LEFT:
      return MouseButton::kLeft;
    case GLFW_MOUSE_BUTTON_RIGHT:
      return MouseButton::kRight;
    case GLFW_MOUSE_BUTTON_MIDDLE:
      return MouseButton::kMiddle;
    default:
      return std::nullopt;
  }
}

// The first pad that GLFW has a mapping for.
GamepadState read_gamepad() {
  GamepadState state;
  GLFWgamepadstate raw;
  for (int joystick = GLFW_JOYSTICK_1; joystick <= GLFW_JOYSTICK_LAST; ++joystick) {
    if (glfwGetGamepadState(joystick, &raw) != GLFW_TRUE) continue;
    state.connected = true;
    state.left_stick = {raw.axes[GLFW_GAMEPAD_AXIS_LEFT_X], raw.axes[GLFW_GAMEPAD_AXIS_LEFT_Y]};
    state.right_stick = {raw.axes[GLFW_GAMEPAD_AXIS_RIGHT_X], raw.axes[GLFW_GAMEPAD_AXIS_RIGHT_Y]};
    // GLFW's triggers rest at -1.
    state.left_trigger = 0.5f * (raw.axes[GLFW_GAMEPAD_AXIS_LEFT_TRIGGER] + 1.0f);
    state.right_trigger = 0.5f * (raw.axes[GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER] + 1.0f);
    for (const PadPair& pair : kPadButtons) {
      state.buttons[static_cast<std::size_t>(pair.button)] = raw.buttons[pair.glfw] == GLFW_PRESS;
    }
    break;
  }
  return state;
}

Input* input_of(GLFWwindow* window) {
  return static_cast<Input*>(glfwGetWindowUserPointer(window));
}

}  // namespace

float without_dead_zone(float axis, float rest) {
  const float beyond = std::abs(axis) - rest;
  return beyond <= 0.0f ? 0.0f : std::copysign(std::fmin(beyond / (1.0f - rest), 1.0f), axis);
}

Input::~Input() {
  if (window_ != nullptr) glfwSetWindowUserPointer(window_->handle(), nullptr);
}

void Input::attach(Window& window) {
  window_ = &window;
  GLFWwindow* handle = window.handle();
  glfwSetWindowUserPointer(handle, this);
  glfwSetKeyCallback(handle, [](GLFWwindow* from, int glfw_key, int, int action, int) {
    const std::optional<Key> key = key_from_glfw(glfw_key);
    Input* input = input_of(from);
    if (input != nullptr && key && action != GLFW_REPEAT) input->on_key(*key, action == GLFW_PRESS);
  });
  glfwSetMouseButtonCallback(handle, [](GLFWwindow* from, int glfw_button, int action, int) {
    const std::optional<MouseButton> button = button_from_glfw(glfw_button);
    Input* input = input_of(from);
    if (input != nullptr && button) input->on_button(*button, action == GLFW_PRESS);
  });
  glfwSetCursorPosCallback(handle, [](GLFWwindow* from, double x, double y) {
    if (Input* input = input_of(from)) input->on_cursor({x, y});
  });
  glfwSetScrollCallback(handle, [](GLFWwindow* from, double x, double y) {
    if (Input* input = input_of(from)) input->on_scroll({x, y});
  });
}

void Input::begin_frame() {
  keys_.begin_frame();
  mouse_.begin_frame();
  pad_.begin_frame();
  mouse_delta_ = scroll_ = glm::dvec2(0.0);
  if (window_ != nullptr) on_gamepad(read_gamepad());
}

void Input::capture_mouse(bool captured) {
  if (captured == captured_) return;
  captured_ = captured;
  cursor_known_ = false;  // the pointer is about to jump
  if (window_ == nullptr) return;
  glfwSetInputMode(window_->handle(), GLFW_CURSOR,
                   captured ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
  if (glfwRawMouseMotionSupported() == GLFW_TRUE) {
    glfwSetInputMode(window_->handle(), GLFW_RAW_MOUSE_MOTION, captured ? GLFW_TRUE : GLFW_FALSE);
  }
}

void Input::on_cursor(glm::dvec2 position) {
  if (cursor_known_) mouse_delta_ += position - cursor_;
  cursor_ = position;
  cursor_known_ = true;
}

void Input::on_gamepad(const GamepadState& state) {
  gamepad_ = state;
  for (glm::vec2* stick : {&gamepad_.left_stick, &gamepad_.right_stick}) {
    *stick = {without_dead_zone(stick->x), without_dead_zone(stick->y)};
  }
  for (std::size_t i = 0; i < state.buttons.size(); ++i) pad_.set(i, state.buttons[i]);
}

}  // namespace offing
